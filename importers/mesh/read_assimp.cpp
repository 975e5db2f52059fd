#include <assimp/scene.h>

#include <algorithm>
#include <cmath>

#include "importers/mesh/assimp_facts.h"
#include "importers/mesh/assimp_scene.h"
#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

/// Where a file of a format stands after assimp, if neither the file nor assimp says so.
struct Convention {
    const char* extension;
    std::optional<double> metres_per_unit;
    char up;      // 0: the format does not say
    bool turned;  // assimp turns z up to y up, which is taken back
};
constexpr Convention conventions[]{
    {"3ds", {}, 'z', true},  {"prj", {}, 'z', true},     {"ase", {}, 'z', true},   {"ask", {}, 'z', true},
    {"dxf", {}, 'z', true},  {"md2", {}, 'z', true},     {"md3", {}, 'z', true},   {"mdc", {}, 'z', true},
    {"iqm", {}, 'z', true},  {"md5mesh", {}, 'z', true}, {"dae", 1., 'y', false},  {"gltf", 1., 'y', false},
    {"glb", 1., 'y', false}, {"x3d", 1., 'y', false},    {"x3db", 1., 'y', false}, {"lwo", 1., 'y', false},
    {"lxo", 1., 'y', false}, {"lws", 1., 'y', false},    {"blend", {}, 'z', false}};

Convention convention_of(const std::string& extension)
{
    for (const Convention& convention : conventions)
        if (extension == convention.extension) return convention;
    return {"", {}, 0, false};
}

/// FBX states its unit in centimetres and its up axis with a sign; assimp tells both and applies neither.
void settle_fbx(const AssimpScene& scene, const MeshSource& source, Convention& convention, SceneReading& reading)
{
    const double centimetres = scene.number("UnitScaleFactor").value_or(1);
    if (!(centimetres > 0) || !std::isfinite(centimetres))
        throw InputError(source.place, "its UnitScaleFactor is " + std::to_string(centimetres), "must be > 0");
    convention.metres_per_unit = seven_digits(centimetres / 100);
    const int axis = std::clamp(static_cast<int>(scene.number("UpAxis").value_or(1)), 0, 2);
    convention.up = "xyz"[axis];
    if (scene.number("UpAxisSign").value_or(1) >= 0) return;
    reading.to_file.linear()(axis, axis) = -1;  // half a turn about a level axis
    reading.to_file.linear()((axis + 1) % 3, (axis + 1) % 3) = -1;
}

/// The name by which a 3DS file has an object that assimp calls "3DSMesh_7".
std::string name_of_3ds(const std::vector<std::string>& names, const aiNode& node, const aiScene& scene)
{
    const std::string name = own_name(node, scene);
    if (!name.starts_with("3DSMesh_") || node.mNumMeshes == 0) return name;
    const auto number = text::parse_integer(scene.mMeshes[node.mMeshes[0]]->mName.C_Str());
    return number && *number >= 0 && *number < static_cast<long long>(names.size())
               ? names[static_cast<std::size_t>(*number)]
               : name;
}

MeshFile read_amf(const MeshSource& source)
{
    const AmfFacts facts = amf_facts(source);
    const AssimpScene scene(source, "amf");
    SceneReading reading;
    reading.name_of = [&](const aiNode& node, const aiScene&) {
        const auto known = facts.names.find(node.mName.C_Str());
        return known == facts.names.end() ? std::string() : known->second;
    };
    MeshFile file = surfaces_of(source, *scene, reading);
    file.metres_per_unit = facts.metres_per_unit;
    return file;
}

}  // namespace

MeshFile read_assimp(const MeshSource& source, const std::string& extension)
{
    if (extension == "ifc") return read_ifc(source);
    if (extension == "amf") return read_amf(source);
    Convention convention = convention_of(extension);
    SceneReading reading;
    reading.name_of = own_name;
    if (convention.turned) reading.to_file.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    reading.single = extension == "3ds" || extension == "lwo";
    const AssimpScene scene(extension == "3ds" ? without_key_frames(source) : source, extension);
    if (extension == "fbx") settle_fbx(scene, source, convention, reading);
    std::vector<std::string> names;
    if (extension == "3ds") {
        names = names_in_3ds(source);
        reading.name_of = [&](const aiNode& node, const aiScene& all) { return name_of_3ds(names, node, all); };
    }
    if (extension == "ogex") {
        const OgexFacts facts = ogex_facts(source);
        convention.metres_per_unit = facts.metres_per_unit;
        convention.up = facts.up;
    }
    MeshFile file = surfaces_of(source, *scene, reading);
    file.metres_per_unit = convention.metres_per_unit;
    if (convention.up != 0) file.up = convention.up;
    return file;
}

}  // namespace voussoir::importers::mesh
