#include "importers/mesh/dxf_pairs.h"

#include <charconv>
#include <cstdint>
#include <system_error>

#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

std::vector<DxfPair> pairs_of(const MeshSource& source)
{
    std::vector<DxfPair> pairs;
    Lines lines(source.bytes);
    for (std::string_view code, value; lines.next(code);) {
        if (text::trim(code).empty()) break;
        const std::optional<long long> number = text::parse_integer(text::trim(code));
        if (!number || *number < -10 || *number > 1100)
            throw InputError(source.place + ":" + std::to_string(lines.number()),
                             "\"" + std::string(text::trim(code).substr(0, 40)) + "\" is not a group code",
                             "a DXF file alternates lines of codes and values");
        if (!lines.next(value)) break;
        pairs.push_back({static_cast<int>(*number), text::trim(value), lines.number()});
        if (*number == 0 && pairs.back().value == "EOF") break;
    }
    return pairs;
}

std::optional<double> metres(std::string_view insunits)
{
    const std::map<long long, double> known{{1, 0.0254}, {2, 0.3048}, {3, 1609.344}, {4, 1e-3},    {5, 1e-2},
                                            {6, 1},      {7, 1e3},    {8, 2.54e-8},  {9, 2.54e-5}, {10, 0.9144},
                                            {13, 1e-6},  {14, 0.1},   {15, 10},      {16, 100}};
    const auto found = known.find(text::parse_integer(insunits).value_or(0));
    return found == known.end() ? std::nullopt : std::optional<double>(found->second);
}

}  // namespace

std::string dxf_name(std::string_view value)
{
    std::string name;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const std::string_view hex = value.substr(i).starts_with("\\U+") ? value.substr(i + 3).substr(0, 4) : "";
        std::uint32_t code = 0;
        const auto [end, error] = std::from_chars(hex.data(), hex.data() + hex.size(), code, 16);
        const bool escaped = hex.size() == 4 && error == std::errc() && end == hex.data() + 4;
        const bool character = escaped && (code < 0xD800 || code > 0xDFFF);
        if (character)
            text::append_utf8(code, name);
        else
            name.push_back(value[i]);
        i += character ? 6 : 0;
    }
    return name;
}

DxfFile read_dxf_pairs(const MeshSource& source)
{
    DxfFile file;
    file.pairs = pairs_of(source);
    std::string_view section;
    std::size_t block = 0;
    for (std::size_t i = 0; i < file.pairs.size(); ++i) {
        const DxfPair& pair = file.pairs[i];
        const DxfPair* next = i + 1 < file.pairs.size() ? &file.pairs[i + 1] : nullptr;
        if (pair.code == 9 && pair.value == "$INSUNITS" && next != nullptr)
            file.metres_per_unit = metres(next->value);
        if (pair.code != 0) continue;
        if (pair.value == "SECTION" && next != nullptr && next->code == 2) {
            section = next->value;
            if (section == "ENTITIES") file.entities = {i + 2, 0};
        } else if (pair.value == "ENDSEC") {
            if (section == "ENTITIES") file.entities.end = i;
            section = {};
        } else if (pair.value == "BLOCK") {
            block = i;
        } else if (pair.value == "ENDBLK") {
            for (std::size_t k = block + 1; k < i && file.pairs[k].code != 0; ++k)
                if (file.pairs[k].code == 2) file.blocks[std::string(file.pairs[k].value)] = {block, i};
        }
    }
    if (!section.empty() || file.entities.end == 0)
        throw InputError(source.place,
                         section.empty()
                             ? "it has no section ENTITIES"
                             : "the file ends within its section " + std::string(section.substr(0, 40)),
                         "the file was cut off, or it is not a DXF file");
    return file;
}

}  // namespace voussoir::importers::mesh
