#include "importers/mesh/assimp_facts.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <pugixml.hpp>

#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

constexpr double max_instances = 100'000;

class AmfText
{
 public:
    explicit AmfText(const MeshSource& source) : source_(source)
    {
        const pugi::xml_parse_result parsed = xml_.load_buffer(source.bytes.data(), source.bytes.size());
        if (!parsed)
            throw InputError(line_place(source.place, source.bytes, parsed.offset),
                             std::string("this is not XML: ") + parsed.description(),
                             "the file was cut off or damaged");
    }

    AmfFacts facts() const
    {
        const pugi::xml_node root = xml_.child("amf");
        AmfFacts facts;
        facts.metres_per_unit = metres(root);
        std::map<std::string, double> stones;  // that an object or a constellation places
        for (const pugi::xml_node& object : root.children("object")) {
            const std::string id = object.attribute("id").value();
            for (const pugi::xml_node& mesh : object.children("mesh")) check_one_volume(mesh);
            stones[id] = 1;
            facts.names[id] = name_of(object);
        }
        for (const pugi::xml_node& constellation : root.children("constellation")) {
            double placed = 0;
            for (const pugi::xml_node& instance : constellation.children("instance")) {
                check_not_turned(instance);
                const auto known = stones.find(instance.attribute("objectid").value());
                if (known == stones.end())
                    refuse(instance, "it places an object that does not stand before it", "check `objectid`");
                placed += known->second;
            }
            if (placed > max_instances)
                refuse(constellation, "this constellation is too large",
                       "it may place " + std::to_string(static_cast<int>(max_instances)) + " objects");
            stones[constellation.attribute("id").value()] = placed;
        }
        return facts;
    }

 private:
    [[noreturn]] void refuse(const pugi::xml_node& at, const std::string& found, const std::string& expected) const
    {
        throw InputError(line_place(source_.place, source_.bytes, at.offset_debug()), found, expected);
    }

    double metres(const pugi::xml_node& root) const
    {
        const std::string unit =
            text::lower_case(root.attribute("unit").as_string("millimeter"));  // as the standard says
        const std::map<std::string, double> known{{"micron", 1e-6}, {"millimeter", 1e-3}, {"millimeters", 1e-3},
                                                  {"inch", 0.0254}, {"feet", 0.3048},     {"meter", 1}};
        const auto found = known.find(unit);
        if (found == known.end())
            throw InputError(source_.place, "its unit is \"" + unit + "\"", "AMF knows no such unit");
        return found->second;
    }

    static std::string name_of(const pugi::xml_node& object)
    {
        for (const pugi::xml_node& metadata : object.children("metadata"))
            if (std::string_view(metadata.attribute("type").value()) == "name")
                return std::string(text::trim(metadata.text().get()));
        return std::string("object ") + object.attribute("id").value();
    }

    /// Of a mesh in several volumes assimp keeps the first and says nothing.
    void check_one_volume(const pugi::xml_node& mesh) const
    {
        const auto volumes = mesh.children("volume");
        const auto count = std::distance(volumes.begin(), volumes.end());
        if (count > 1)
            refuse(
                mesh,
                "this mesh has " + std::to_string(count) + " volumes, of which assimp, which reads AMF, keeps one",
                "export one volume for each object, or as 3MF");
    }

    /// assimp takes <rx>, <ry> and <rz> for <deltax>, <deltay> and <deltaz>: harmless only where all are zero.
    void check_not_turned(const pugi::xml_node& instance) const
    {
        const auto number = [&](const char* name) {
            return text::parse_number(text::trim(instance.child(name).text().as_string("0"))).value_or(1);
        };
        for (const char axis : {'x', 'y', 'z'}) {
            const std::string turn = std::string("r") + axis, shift = std::string("delta") + axis;
            if (instance.child(turn.c_str()) && (number(turn.c_str()) != 0 || number(shift.c_str()) != 0))
                refuse(instance,
                       "an instance with <" + turn + "> is not placed rightly by assimp, which reads AMF",
                       "export the stones where they stand, or as 3MF");
        }
    }

    const MeshSource& source_;
    pugi::xml_document xml_;
};

/// The number or word in the braces of a statement `Metric (key = "up") {string {"z"}}`; empty: there is none.
std::string metric(std::string_view text, const std::string& key)
{
    for (std::size_t at = text.find("Metric"); at != text.npos; at = text.find("Metric", at + 1)) {
        const std::size_t open = text.find('{', at);
        if (open == text.npos) break;
        if (text.substr(at, open - at).find('"' + key + '"') == text.npos) continue;
        const std::size_t inner = text.find('{', open + 1), end = text.find('}', open + 1);
        if (inner == text.npos || end == text.npos || inner > end) break;
        std::string word(text::trim(text.substr(inner + 1, end - inner - 1)));
        std::erase(word, '"');
        return word;
    }
    return "";
}

/// Calls use(kind, first byte, end) for every chunk of a 3DS file between two bytes; damage is assimp's to judge.
template <class Use>
void for_each_chunk(const std::string& bytes, std::size_t at, std::size_t end, const Use& use)
{
    while (at + 6 <= end) {
        const std::size_t length = load<std::uint32_t>(&bytes[at + 2]);
        if (length < 6 || length > end - at) return;
        use(load<std::uint16_t>(&bytes[at]), at + 6, at + length);
        at += length;
    }
}

}  // namespace

AmfFacts amf_facts(const MeshSource& source)
{
    return AmfText(source).facts();
}

std::vector<std::string> names_in_3ds(const MeshSource& source)
{
    constexpr int editor = 0x3D3D, object = 0x4000, mesh = 0x4100;
    const std::string& bytes = source.bytes;
    std::vector<std::string> names;
    const auto see_object = [&](int kind, std::size_t at, std::size_t end) {
        const std::size_t name_end = kind == object ? bytes.find('\0', at) : bytes.npos;
        if (name_end >= end) return;
        for_each_chunk(bytes, name_end + 1, end, [&](int inner, std::size_t, std::size_t) {
            if (inner == mesh) names.push_back(bytes.substr(at, name_end - at));
        });
    };
    for_each_chunk(bytes, 6, bytes.size(), [&](int kind, std::size_t at, std::size_t end) {
        if (kind == editor) for_each_chunk(bytes, at, end, see_object);
    });
    return names;
}

MeshSource without_key_frames(const MeshSource& source)
{
    constexpr int key_frames = 0xB000;
    MeshSource still = source;
    if (source.bytes.size() < 6) return still;
    std::size_t removed = 0;
    for_each_chunk(source.bytes, 6, source.bytes.size(), [&](int kind, std::size_t at, std::size_t end) {
        if (kind != key_frames) return;
        still.bytes.erase(at - 6 - removed, end - at + 6);
        removed += end - at + 6;
    });
    const auto length = static_cast<std::uint32_t>(load<std::uint32_t>(&source.bytes[2]) - removed);
    for (std::size_t i = 0; i < 4; ++i) still.bytes[2 + i] = static_cast<char>(length >> 8 * i & 0xFF);
    return still;
}

OgexFacts ogex_facts(const MeshSource& source)
{
    OgexFacts facts;
    const std::string distance = metric(source.bytes, "distance"), up = metric(source.bytes, "up");
    if (!distance.empty()) {
        const std::optional<double> metres = text::parse_finite(distance);
        if (!metres || *metres <= 0)
            throw InputError(source.place, "its unit of length is " + distance + " m", "write a number > 0");
        facts.metres_per_unit = *metres;
    }
    if (!up.empty() && up != "y" && up != "z")
        throw InputError(source.place, "its up axis is \"" + up + "\"", "OpenGEX has y and z");
    if (!up.empty()) facts.up = up[0];
    return facts;
}

}  // namespace voussoir::importers::mesh
