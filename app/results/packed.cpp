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

std::string read_packed(const std::filesystem::path& path, std::string_view mark, const std::string& what)
{
    const std::string file = read_whole_file(path);
    std::uint64_t stored = 0;
    if (!std::string_view(file).starts_with(mark) || file.size() < mark.size() + sizeof stored) {
        throw InputError(path.string(), "not " + what + " of this version of voussoir",
                         "give " + what + " that this version wrote");
    }
    std::string payload = file.substr(mark.size(), file.size() - mark.size() - sizeof stored);
    std::memcpy(&stored, file.data() + file.size() - sizeof stored, sizeof stored);
    if (stored != fnv1a(payload)) refuse_damaged(path);
    return payload;
}

void refuse_damaged(const std::filesystem::path& path)
{
    throw InputError(path.string(), "damaged", "start the run again");
}

}  // namespace voussoir::app::results
