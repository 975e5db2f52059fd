#include "importers/mesh/gltf_container.h"

#include <cstdint>
#include <optional>

#include "libdda/errors.h"

namespace voussoir::importers::mesh
{

namespace
{

constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

std::optional<std::string> from_base64(std::string_view text)
{
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text.substr(0, text.find('='))) {
        const std::size_t value = digits.find(c);
        if (value == std::string_view::npos) return std::nullopt;
        bits = bits << 6 | static_cast<unsigned>(value);
        count += 6;
        if (count >= 8) bytes.push_back(static_cast<char>(bits >> (count -= 8) & 0xFF));
    }
    return bytes;
}

/// "my%20stones.bin" is "my stones.bin".
std::string without_escapes(const std::string& uri)
{
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool escaped =
            uri[i] == '%' && i + 2 < uri.size() && uri.find_first_not_of("0123456789abcdefABCDEF", i + 1) > i + 2;
        text.push_back(escaped ? static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i]);
        if (escaped) i += 2;
    }
    return text;
}

}  // namespace

GltfContainer open_gltf(const MeshSource& source)
{
    const std::string& bytes = source.bytes;
    if (!bytes.starts_with("glTF")) return {bytes, ""};
    if (bytes.size() < 20 || load<std::uint32_t>(&bytes[4]) != 2)
        throw InputError(source.place, "this is not version 2 of GLB, or it is cut off", "export it as glTF 2.0");
    GltfContainer content;
    for (std::size_t at = 12; at + 8 <= bytes.size();) {
        const std::size_t length = load<std::uint32_t>(&bytes[at]);
        const std::uint32_t kind = load<std::uint32_t>(&bytes[at + 4]);
        if (length > bytes.size() - at - 8)
            throw InputError(source.place,
                             "a chunk of " + std::to_string(length) + " bytes begins at byte " +
                                 std::to_string(at) + ", but the file has " + std::to_string(bytes.size()),
                             "the file was cut off");
        if (kind == json_chunk) content.json = bytes.substr(at + 8, length);
        if (kind == binary_chunk) content.binary = bytes.substr(at + 8, length);
        at += 8 + length;
    }
    return content;
}

std::string content_of_uri(const std::string& uri, const MeshSource& source)
{
    if (uri.starts_with("data:")) {
        const std::size_t start = uri.find(";base64,");
        const std::optional<std::string> bytes =
            start == std::string::npos ? std::nullopt : from_base64(std::string_view(uri).substr(start + 8));
        if (bytes) return *bytes;
        throw InputError(source.place, "the data of a buffer are not in base 64", "export it again");
    }
    const std::filesystem::path path = without_escapes(uri);
    bool beside = path.is_relative() && uri.find("://") == std::string::npos;
    for (const std::filesystem::path& part : path) beside = beside && part != "..";
    if (!beside)
        throw InputError(source.place, "a buffer is at \"" + uri.substr(0, 100) + "\"",
                         "buffers must lie beside the file, or export it as GLB, which holds all in one");
    return read_bytes(source.path.parent_path() / path);
}

}  // namespace voussoir::importers::mesh
