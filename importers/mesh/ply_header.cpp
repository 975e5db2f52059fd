#include "importers/mesh/ply_header.h"

#include <array>
#include <utility>

#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

PlyType type_of(std::string_view word)
{
    constexpr std::array<std::pair<std::string_view, PlyType>, 16> names{{{"char", PlyType::int8},
                                                                          {"int8", PlyType::int8},
                                                                          {"uchar", PlyType::uint8},
                                                                          {"uint8", PlyType::uint8},
                                                                          {"short", PlyType::int16},
                                                                          {"int16", PlyType::int16},
                                                                          {"ushort", PlyType::uint16},
                                                                          {"uint16", PlyType::uint16},
                                                                          {"int", PlyType::int32},
                                                                          {"int32", PlyType::int32},
                                                                          {"uint", PlyType::uint32},
                                                                          {"uint32", PlyType::uint32},
                                                                          {"float", PlyType::float32},
                                                                          {"float32", PlyType::float32},
                                                                          {"double", PlyType::float64},
                                                                          {"float64", PlyType::float64}}};
    for (const auto& [name, type] : names)
        if (name == word) return type;
    return PlyType::none;
}

bool read_format(const std::vector<std::string_view>& word, PlyHeader& header)
{
    if (word.size() < 2) return false;
    if (word[1] == "ascii")
        header.format = PlyHeader::Format::ascii;
    else if (word[1] == "binary_little_endian")
        header.format = PlyHeader::Format::little_endian;
    else if (word[1] == "binary_big_endian")
        header.format = PlyHeader::Format::big_endian;
    else
        return false;
    return true;
}

bool read_element(const std::vector<std::string_view>& word, PlyHeader& header)
{
    const long long count = word.size() == 3 ? text::parse_integer(word[2]).value_or(-1) : -1;
    if (count >= 0) header.elements.push_back({std::string(word[1]), static_cast<std::size_t>(count), {}});
    return count >= 0;
}

bool read_property(const std::vector<std::string_view>& word, PlyHeader& header)
{
    if (header.elements.empty() || word.size() < 3) return false;
    const bool list = word[1] == "list";
    if (word.size() != (list ? 5U : 3U)) return false;
    PlyProperty property{std::string(word.back()), type_of(word[list ? 3 : 1]),
                         list ? type_of(word[2]) : PlyType::none};
    const bool good = property.type != PlyType::none &&
                      (!list || (property.count != PlyType::none && property.count < PlyType::float32));
    header.elements.back().properties.push_back(std::move(property));
    return good;
}

/// A count that the rest of the file cannot hold is refused before anything is allocated for it.
void check_counts(const PlyHeader& header, const MeshSource& source)
{
    const std::size_t left = source.bytes.size() - header.size;
    for (const PlyElement& element : header.elements) {
        std::size_t least = 0;  // bytes of one; a number and a space in text
        for (const PlyProperty& property : element.properties)
            least += header.format == PlyHeader::Format::ascii
                         ? 2
                         : size_of(property.count == PlyType::none ? property.type : property.count);
        if (element.count > (left + 1) / std::max<std::size_t>(least, 1))
            throw InputError(
                source.place,
                "the header announces " + std::to_string(element.count) + " elements \"" + element.name + "\"",
                "the " + std::to_string(left) + " bytes after the header cannot hold them");
    }
}

}  // namespace

std::size_t size_of(PlyType type)
{
    constexpr std::array<std::size_t, 9> sizes{0, 1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

PlyHeader read_ply_header(const MeshSource& source)
{
    PlyHeader header;
    Lines lines(source.bytes);
    bool has_format = false;
    for (std::string_view line; lines.next(line);) {
        const std::vector<std::string_view> word = text::words(line);
        const auto at = [&] { return source.place + ":" + std::to_string(lines.number()); };
        if (lines.number() == 1 && (word.empty() || word[0] != "ply"))
            throw InputError(at(), "the file does not begin with `ply`", "give a PLY file");
        if (word.empty() || word[0] == "ply" || word[0] == "comment" || word[0] == "obj_info") continue;
        if (word[0] == "end_header") {
            if (!has_format)
                throw InputError(at(), "the header has no `format` line", "it says ascii or binary_...");
            header.lines = lines.number();
            const char* end = line.data() + line.size();  // then "\n" or "\r\n"; after a lone "\r" data may begin
            header.size = static_cast<std::size_t>(end - source.bytes.data());
            header.size += source.bytes.compare(header.size, 2, "\r\n") == 0 ? 2 : 1;
            header.size = std::min(header.size, source.bytes.size());
            check_counts(header, source);
            return header;
        }
        const bool good = word[0] == "format"     ? (has_format = read_format(word, header))
                          : word[0] == "element"  ? read_element(word, header)
                          : word[0] == "property" ? read_property(word, header)
                                                  : false;
        if (!good)
            throw InputError(at(), "\"" + std::string(line.substr(0, 60)) + "\" is not understood",
                             "header lines are format, element, property, comment and end_header");
    }
    throw InputError(source.place, "the header has no `end_header`",
                     "the file was cut off, or it is not a PLY file");
}

}  // namespace voussoir::importers::mesh
