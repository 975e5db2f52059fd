#include "importers/mesh/file_kind.h"

#include <cstdint>

#include "importers/mesh/mesh_formats.h"
#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

/// How files that only assimp reads begin.
struct Beginning {
    const char* text;
    const char* extension;
};
const Beginning beginnings[]{{"Kaydara FBX", "fbx"},
                             {"; FBX ", "fbx"},
                             {"xof ", "x"},
                             {"IDP2", "md2"},
                             {"IDP3", "md3"},
                             {"IDPC", "mdc"},
                             {"MS3D000000", "ms3d"},
                             {"BB3D", "b3d"},
                             {"AC3D", "ac"},
                             {"Caligari ", "cob"},
                             {"MD5Version", "md5mesh"},
                             {"quick3D", "q3o"},
                             {"*3DSMAX_ASCII", "ase"},
                             {"BLENDER", "blend"},
                             {"INTERQUAKEMODEL", "iqm"},
                             {"PMX ", "pmx"},
                             {"ASSIMP.binary", "assbin"},
                             {"LWSC", "lws"},
                             {" nendo ", "ndo"}};

FileKind assimp_kind(const std::string& extension)
{
    return {Kind::assimp, extension};
}

FileKind kind_of_xml(std::string_view text)
{
    const auto has = [&](const char* tag) { return text.find(tag) != text.npos; };
    if (has("<COLLADA")) return {Kind::collada, "dae"};
    if (has("<amf") || has("<AMF")) return assimp_kind("amf");
    if (has("<X3D")) return assimp_kind("x3d");
    if (has("<irr_scene")) return assimp_kind("irr");
    if (has("IRRMESH")) return assimp_kind("irrmesh");
    if (has("<submeshes")) return assimp_kind("mesh.xml");
    return has("<WORLD") ? assimp_kind("xgl") : FileKind();
}

FileKind kind_of_json(std::string_view text)
{
    const bool asset = text.find("\"asset\"") != text.npos;
    return asset && (text.find("\"meshes\"") != text.npos || text.find("\"nodes\"") != text.npos)
               ? FileKind{Kind::gltf, "gltf"}
               : FileKind{Kind::compas, ""};
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
        const std::vector<std::string_view> word = text::words(line);
        if (word.empty() || word[0].starts_with('#')) continue;
        ++looked_at;
        Eigen::Vector3d x;
        if (word[0] == "v" && parse_point(word, 1, x)) return true;
    }
    return false;
}

bool looks_like_ogex(std::string_view text)
{
    const std::string_view start = text.substr(0, 1 << 16);
    return start.find("GeometryNode") != start.npos && start.find('{') != start.npos;
}

FileKind kind_of_binary(std::string_view bytes)
{
    if (bytes.starts_with("PK\x03\x04")) return {Kind::archive, "3mf"};
    if (bytes.starts_with("glTF")) return {Kind::gltf, "glb"};
    if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return {Kind::ply, "ply"};
    if (bytes.starts_with("AutoCAD Binary DXF")) return {Kind::dxf, "dxf"};
    for (const Beginning& beginning : beginnings)
        if (bytes.starts_with(beginning.text)) return assimp_kind(beginning.extension);
    if (bytes.starts_with("FORM") && bytes.size() > 12)
        for (const char* form : {"LWO2", "LWOB", "LWLO", "LXOB"})
            if (bytes.substr(8, 4) == form) return assimp_kind("lwo");
    if (bytes.size() > 6 && bytes.starts_with("MM") && load<std::uint32_t>(&bytes[2]) == bytes.size())
        return assimp_kind("3ds");
    return is_binary_stl(bytes) ? FileKind{Kind::stl, "stl"} : FileKind();
}

FileKind kind_of_text(std::string_view bytes)
{
    const std::string_view start = text::trim(bytes.substr(0, 4096));
    const std::vector<std::string_view> word = text::words(start.substr(0, 256));
    if (word.empty()) return {};
    if (start.starts_with("ISO-10303-21")) return {Kind::ifc, "ifc"};
    if (start.find("FBXHeaderExtension") != start.npos) return assimp_kind("fbx");
    if (start.starts_with('<')) return kind_of_xml(bytes.substr(0, 1 << 16));
    if (start.starts_with('{') || start.starts_with('[')) return kind_of_json(bytes);
    if (text::lower_case(word[0]) == "solid" && text::lower_case(start).find("facet") != std::string::npos)
        return {Kind::stl, "stl"};
    if (is_off_keyword(word[0])) return {Kind::off, "off"};
    const bool sections = word[0] == "999" && bytes.find("SECTION") != bytes.npos;
    if (sections || (word.size() > 1 && word[0] == "0" && word[1] == "SECTION")) return {Kind::dxf, "dxf"};
    if (looks_like_ogex(bytes)) return assimp_kind("ogex");
    return looks_like_obj(bytes) ? FileKind{Kind::obj, "obj"} : FileKind();
}

}  // namespace

FileKind kind_by_content(std::string_view bytes)
{
    const FileKind binary = kind_of_binary(bytes);
    return binary.kind != Kind::unknown ? binary : kind_of_text(bytes);
}

FileKind kind_by_name(const std::filesystem::path& path)
{
    const std::string name = text::lower_case(path.filename().string());
    const std::map<std::string, Kind> own{{"obj", Kind::obj},     {"stl", Kind::stl},     {"ply", Kind::ply},
                                          {"off", Kind::off},     {"gltf", Kind::gltf},   {"glb", Kind::gltf},
                                          {"json", Kind::compas}, {"dae", Kind::collada}, {"3mf", Kind::archive},
                                          {"dxf", Kind::dxf}};
    const std::map<std::string, FileKind> packed{
        {"zae", {Kind::collada, "dae"}}, {"ifczip", {Kind::ifc, "ifc"}}, {"ifc", {Kind::ifc, "ifc"}}};
    const std::size_t point = name.rfind('.');
    const std::string extension = point == std::string::npos ? "" : name.substr(point + 1);
    if (const auto found = own.find(extension); found != own.end())
        return {found->second, extension == "json" ? "" : extension};
    if (const auto found = packed.find(extension); found != packed.end()) return found->second;
    for (const MeshFormat& format : mesh_formats())
        for (const std::string& other : format.extensions)
            if (!format.own && name.ends_with("." + other)) return assimp_kind(other);
    return {};
}

void refuse_known_strangers(const MeshSource& source)
{
    const std::string_view bytes = source.bytes;
    const std::string_view start = text::trim(bytes.substr(0, 4096));
    const auto refuse = [&](const char* found, const char* expected) {
        throw InputError(source.place, found, expected);
    };
    if (bytes.starts_with("\x1F\x8B")) refuse("this file is compressed (gzip)", "unpack it");
    if (bytes.starts_with("7z\xBC\xAF") || bytes.starts_with("Rar!") || bytes.starts_with("BZh") ||
        bytes.starts_with("\xFD"
                          "7zXZ"))
        refuse("this file is compressed", "unpack it");
    if (bytes.starts_with("AC10") && bytes.size() > 6) refuse("this is a DWG file", "save it as text DXF");
    if (start.starts_with("ISO-10303-21") && bytes.find("IFC") == std::string_view::npos)
        refuse("STEP files are not read", "export the stones as OBJ or STL");
}

}  // namespace voussoir::importers::mesh
