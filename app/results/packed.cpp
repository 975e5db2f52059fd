#include "app/results/packed.h"

#include <bit>

#include "app/results/atomic_file.h"
#include "libdda/errors.h"

namespace voussoir::app::results
{

static_assert(std::endian::native == std::endian::little, "packed files are little-endian");

std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash)
{
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
    return hash;
}

void write_packed(const std::filesystem::path& path, std::string_view mark, const std::string& payload)
{
    Packer tail;
    tail.field(fnv1a(payload));
    write_atomically(path, std::string(mark) + payload + tail.bytes);
}

namespace
{

void expect_mark(OwnFile& file, const std::filesystem::path& path, std::string_view mark, const std::string& what)
{
    if (file.read(mark.size()) != mark)
        throw InputError(path.string(), "not " + what + " of this version of voussoir",
                         "give " + what + " that this version wrote");
}

}  // namespace

std::string read_packed_head(const std::filesystem::path& path, std::string_view mark, const std::string& what,
                             std::size_t size)
{
    OwnFile file(path);
    expect_mark(file, path, mark, what);
    return file.read(size);
}

std::string read_packed(const std::filesystem::path& path, std::string_view mark, const std::string& what)
{
    OwnFile file(path);
    expect_mark(file, path, mark, what);
    std::uint64_t stored = 0;
    std::string payload = file.read(file.size() - mark.size());
    if (payload.size() < sizeof stored) refuse_damaged(path);
    std::memcpy(&stored, payload.data() + payload.size() - sizeof stored, sizeof stored);
    payload.resize(payload.size() - sizeof stored);
    if (stored != fnv1a(payload)) refuse_damaged(path);
    return payload;
}

void refuse_damaged(const std::filesystem::path& path)
{
    throw InputError(path.string(), "damaged", "start the run again");
}

}  // namespace voussoir::app::results
