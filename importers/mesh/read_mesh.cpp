#include "importers/mesh/read_mesh.h"

#include <algorithm>
#include <cstdint>
#include <fstream>

#include "importers/mesh/formats.h"
#include "importers/mesh/text.h"

namespace voussoir
{

namespace
{

enum class Kind { unknown, obj, stl, ply, off, gltf, compas, collada, amf, archive, max_3ds, dxf, ifc };

/// What cannot be read but is met often, by how it begins.
void refuse_known_strangers(const MeshSource& source)
{
    const std::string_view bytes = source.bytes;
    const std::string_view start = trimmed(bytes.substr(0, 4096));
    const auto refuse = [&](const char* found, const char* expected) {
        throw InputError(source.place, found, expected);
    };
    if (bytes.starts_with("\x1F\x8B")) refuse("this file is compressed (gzip)", "unpack it");
    if (bytes.starts_with("7z\xBC\xAF") || bytes.starts_with("Rar!") || bytes.starts_with("BZh") ||
        bytes.starts_with("\xFD"
                          "7zXZ"))
        refuse("this file is compressed", "unpack it");
    if (bytes.starts_with("Kaydara FBX")) refuse("FBX is not read", "convert it to glTF, COLLADA or OBJ");
    if (bytes.starts_with("BLENDER")) refuse("Blender's own files are not read", "export it as OBJ or glTF");
    if (bytes.starts_with("AC10") && bytes.size() > 6) refuse("this is a DWG file", "save it as text DXF");
    if (start.starts_with("ISO-10303-21") && bytes.find("IFC") == std::string_view::npos)
        refuse("STEP files are not read", "export the stones as OBJ or STL");
}

Kind kind_of_xml(std::string_view text)
{
    if (text.find("<COLLADA") != text.npos) return Kind::collada;
    return text.find("<amf") != text.npos || text.find("<AMF") != text.npos ? Kind::amf : Kind::unknown;
}

Kind kind_of_json(std::string_view text)
{
    const bool asset = text.find("\"asset\"") != text.npos;
    return asset && (text.find("\"meshes\"") != text.npos || text.find("\"nodes\"") != text.npos) ? Kind::gltf
                                                                                                  : Kind::compas;
}

bool is_off_keyword(std::string_view word)
{
    const std::size_t end = word.find("OFF");
    return end != word.npos && word.substr(0, end).find_first_not_of("STCN4n") == word.npos;
}

/// A line that only OBJ has among the first that are neither empty nor comments.
bool looks_like_obj(std::string_view text)
{
    Lines lines(text.substr(0, 1 << 16));
    int looked_at = 0;
    for (std::string_view line; looked_at < 50 && lines.next(line);) {
        const std::vector<std::string_view> word = words(line);
        if (word.empty() || word[0].starts_with('#')) continue;
        ++looked_at;
        Eigen::Vector3d x;
        if (word[0] == "v" && parse_point(word, 1, x)) return true;
    }
    return false;
}

Kind kind_by_content(std::string_view bytes)
{
    const std::string_view start = trimmed(bytes.substr(0, 4096));
    const std::vector<std::string_view> word = words(start.substr(0, 256));
    if (bytes.starts_with("PK\x03\x04")) return Kind::archive;
    if (bytes.starts_with("glTF")) return Kind::gltf;
    if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return Kind::ply;
    if (bytes.starts_with("AutoCAD Binary DXF")) return Kind::dxf;
    if (start.starts_with("ISO-10303-21")) return Kind::ifc;
    if (bytes.size() > 6 && bytes.starts_with("MM") && load<std::uint32_t>(&bytes[2]) == bytes.size())
        return Kind::max_3ds;
    if (is_binary_stl(bytes)) return Kind::stl;
    if (word.empty()) return Kind::unknown;
    if (start.starts_with('<')) return kind_of_xml(bytes.substr(0, 1 << 16));
    if (start.starts_with('{') || start.starts_with('[')) return kind_of_json(bytes);
    if (lower_case(word[0]) == "solid" && lower_case(start).find("facet") != std::string::npos) return Kind::stl;
    if (is_off_keyword(word[0])) return Kind::off;
    if (word.size() > 1 && word[0] == "0" && word[1] == "SECTION") return Kind::dxf;
    if (word[0] == "999" && bytes.find("SECTION") != bytes.npos) return Kind::dxf;
    return looks_like_obj(bytes) ? Kind::obj : Kind::unknown;
}

Kind kind_by_name(const std::filesystem::path& path)
{
    const std::string extension = lower_case(path.extension().string());
    const std::map<std::string, Kind> known{{".obj", Kind::obj},     {".stl", Kind::stl},     {".ply", Kind::ply},
                                            {".off", Kind::off},     {".gltf", Kind::gltf},   {".glb", Kind::gltf},
                                            {".json", Kind::compas}, {".dae", Kind::collada}, {".amf", Kind::amf},
                                            {".3mf", Kind::archive}, {".3ds", Kind::max_3ds}, {".dxf", Kind::dxf},
                                            {".ifc", Kind::ifc}};
    const auto found = known.find(extension);
    return found == known.end() ? Kind::unknown : found->second;
}

MeshFile read_kind(Kind kind, const MeshSource& source, const ReadOptions& options)
{
    switch (kind) {
        case Kind::obj:
            return read_obj(source, options);
        case Kind::stl:
            return read_stl(source);
        case Kind::ply:
            return read_ply(source);
        case Kind::off:
            return read_off(source);
        case Kind::gltf:
            return read_gltf(source);
        case Kind::compas:
            return read_compas(source);
        case Kind::collada:
            return read_collada(source);
        case Kind::amf:
            return read_amf(source);
        case Kind::archive:
            return kind_by_name(source.path) == Kind::amf ? read_amf(source) : read_3mf(source);
        case Kind::max_3ds:
            return read_3ds(source);
        case Kind::dxf:
            return read_dxf(source, options);
        case Kind::ifc:
            return read_ifc(source);
        case Kind::unknown:
            break;
    }
    throw InputError(source.place, "this is not a mesh file in a supported format",
                     "give OBJ, STL, PLY, OFF, glTF, COLLADA, DXF, 3DS, 3MF, AMF, IFC or COMPAS JSON");
}

MeshFile read_source(MeshSource& source, const ReadOptions& options)
{
    std::vector<std::string> repairs;
    if (std::optional<std::string> text = from_utf16(source.bytes)) {
        source.bytes = std::move(*text);
        repairs.push_back("the text is UTF-16 and was read as such");
    }
    if (source.bytes.starts_with("\xEF\xBB\xBF")) source.bytes.erase(0, 3);
    refuse_known_strangers(source);
    const Kind named = kind_by_name(source.path), found = kind_by_content(source.bytes);
    const Kind kind = found == Kind::unknown ? named : found;
    if (found != Kind::unknown && named != Kind::unknown && named != found &&
        !(found == Kind::archive && named == Kind::amf) && !(found == Kind::gltf && named == Kind::compas))
        repairs.push_back("the content does not match the file name, and was read by its own format");
    MeshFile mesh = read_kind(kind, source, options);
    mesh.repairs.insert(mesh.repairs.begin(), repairs.begin(), repairs.end());
    return mesh;
}

void merge_all(MeshFile& mesh, const std::string& name)
{
    PolygonSurface whole{name, {}, {}};
    for (const PolygonSurface& part : mesh.surfaces) append(part, whole);
    mesh.surfaces = {std::move(whole)};
}

}  // namespace

std::string read_bytes(const std::filesystem::path& file)
{
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status))
        throw InputError(file.string(), "there is no such file", "give the path of a mesh file");
    if (!std::filesystem::is_regular_file(status))
        throw InputError(file.string(), "this is not a file", "give the path of a mesh file");
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(std::filesystem::file_size(file, error), '\0');
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
        throw InputError(file.string(), "the file cannot be read", "check its permissions");
    if (bytes.empty()) throw InputError(file.string(), "the file is empty", "a mesh file has vertices and faces");
    return bytes;
}

MeshFile read_mesh(const std::filesystem::path& file, const ReadOptions& options)
{
    MeshSource source{file, file.string(), as_utf8(file.stem().string()), read_bytes(file)};
    try {
        MeshFile mesh = read_source(source, options);
        if (options.stones == StonesBy::file) merge_all(mesh, source.name);
        for (std::string& repair : mesh.repairs) repair = as_utf8(repair);
        return mesh;
    } catch (InputError& error) {  // words of the file are quoted in faults: they must be text
        std::vector<Fault> faults = std::move(error.faults);
        for (Fault& fault : faults) fault = {as_utf8(fault.place), as_utf8(fault.found), as_utf8(fault.expected)};
        throw InputError(std::move(faults));
    }
}

}  // namespace voussoir
