#include "importers/mesh/mesh_formats.h"

#include <assimp/importerdesc.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <set>

#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

const char* const digits = "coordinates beyond 7 digits";

/// What is known of formats that assimp reads; README.md has the measurements.
struct Known {
    const char* extension;  // one of those of the importer
    const char* name;
    const char* lost;  // beside the digits; null: nothing at all
};
const std::vector<Known> known{
    {"fbx", "Autodesk FBX", ""},
    {"x3d", "X3D", "UNIT statements, names of shapes"},
    {"lwo", "LightWave and Modo objects", nullptr},
    {"ogex", "OpenGEX", "meshes whose transforms are not matrices"},
    {"3ds", "3D Studio 3DS", nullptr},
    {"amf", "AMF", "turned instances and meshes of several volumes, which are refused"},
    {"ifc", "IFC", "openings where its cuts fail"},
    {"ase", "3D Studio ASE", "unit"},
    {"blend", "Blender", "unit, modifiers"},
};

/// Formats of motions, of several files that hold no meshes of their own, and those of the readers written here.
const std::set<std::string> left_out{"bvh", "csm", "vta", "mot", "md5anim", "md5camera"};

std::vector<MeshFormat> own_formats()
{
    return {{"Wavefront OBJ", {"obj"}, true, ""}, {"STL", {"stl"}, true, ""},
            {"Stanford PLY", {"ply"}, true, ""},  {"OFF", {"off"}, true, ""},
            {"glTF", {"gltf", "glb"}, true, ""},  {"COLLADA", {"dae", "zae"}, true, ""},
            {"3MF", {"3mf"}, true, ""},           {"DXF", {"dxf"}, true, "solids (ACIS)"},
            {"COMPAS JSON", {"json"}, true, ""}};
}

std::vector<std::string> extensions_of(const aiImporterDesc& importer, const std::set<std::string>& taken)
{
    std::vector<std::string> extensions;
    for (const std::string_view word : text::words(importer.mFileExtensions)) {
        const std::string extension = text::lower_case(word);
        if (!taken.contains(extension) && !left_out.contains(extension)) extensions.push_back(extension);
    }
    return extensions;
}

MeshFormat described(const aiImporterDesc& importer, std::vector<std::string> extensions)
{
    MeshFormat format{importer.mName, std::move(extensions), false, std::string(digits) + ", unit and up axis"};
    for (const char* word : {" Importer", " Reader", " importer"})
        if (const std::size_t at = format.name.find(word); at != std::string::npos)
            format.name.erase(at, std::string(word).size());
    for (const Known& entry : known) {
        if (std::find(format.extensions.begin(), format.extensions.end(), entry.extension) ==
            format.extensions.end())
            continue;
        format.name = entry.name;
        format.lost = entry.lost == nullptr ? "" : digits + std::string(*entry.lost != 0 ? ", " : "") + entry.lost;
    }
    return format;
}

}  // namespace

std::vector<MeshFormat> mesh_formats()
{
    std::vector<MeshFormat> formats = own_formats();
    std::set<std::string> taken{"xml"};  // no format: the content tells
    for (const MeshFormat& format : formats) taken.insert(format.extensions.begin(), format.extensions.end());
    const Assimp::Importer assimp;
    for (std::size_t i = 0; i < assimp.GetImporterCount(); ++i) {
        const aiImporterDesc& importer = *assimp.GetImporterInfo(i);
        std::vector<std::string> extensions = extensions_of(importer, taken);
        if (extensions.empty()) continue;
        taken.insert(extensions.begin(), extensions.end());
        formats.push_back(described(importer, std::move(extensions)));
    }
    return formats;
}

}  // namespace voussoir::importers::mesh
