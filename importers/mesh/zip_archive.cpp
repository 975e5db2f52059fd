#include <zip.h>

#include <memory>

#include "importers/mesh/formats.h"
#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

constexpr std::size_t max_bytes = std::size_t{1} << 30;

struct Discard {
    void operator()(zip_t* archive) const { zip_discard(archive); }
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};

std::string unpack(zip_t* archive, zip_uint64_t index, std::size_t most, const MeshSource& source)
{
    const std::unique_ptr<zip_file_t, Discard> file(zip_fopen_index(archive, index, 0));
    std::string content, chunk(std::size_t{1} << 16, '\0');
    zip_int64_t got = -1;
    while (file && (got = zip_fread(file.get(), chunk.data(), chunk.size())) > 0) {
        content.append(chunk, 0, static_cast<std::size_t>(got));
        if (content.size() > most)
            throw InputError(source.place, "this archive unpacks to more than 1 GiB", "give a smaller file");
    }
    if (got < 0) throw InputError(source.place, "a part of the archive cannot be unpacked", "the file is damaged");
    return content;
}

}  // namespace

std::map<std::string, std::string> unzipped(const MeshSource& archive, const std::string& ending)
{
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* bytes = zip_source_buffer_create(archive.bytes.data(), archive.bytes.size(), 0, &error);
    const std::unique_ptr<zip_t, Discard> zip(bytes != nullptr ? zip_open_from_source(bytes, ZIP_RDONLY, &error)
                                                               : nullptr);
    if (!zip) {
        if (bytes != nullptr) zip_source_free(bytes);
        throw InputError(archive.place, "this archive cannot be opened", "the file was cut off or damaged");
    }
    std::map<std::string, std::string> parts;
    std::size_t sum = 0;
    for (zip_int64_t i = 0; i < zip_get_num_entries(zip.get(), 0); ++i) {
        const auto index = static_cast<zip_uint64_t>(i);
        const char* found = zip_get_name(zip.get(), index, ZIP_FL_ENC_GUESS);
        const std::string name = found != nullptr ? found : "";
        if (!text::lower_case(name).ends_with(ending)) continue;
        std::string& content = parts[name] = unpack(zip.get(), index, max_bytes - sum, archive);
        sum += content.size();
        if (std::optional<std::string> text = text::from_utf16(content)) content = std::move(*text);
    }
    return parts;
}

MeshSource unpacked(const MeshSource& archive, const std::string& ending)
{
    std::map<std::string, std::string> parts = unzipped(archive, ending);
    if (parts.empty())
        throw InputError(archive.place, "this archive holds no " + ending + " file", "it was packed by mistake");
    MeshSource content = archive;
    content.bytes = std::move(parts.begin()->second);
    return content;
}

}  // namespace voussoir::importers::mesh
