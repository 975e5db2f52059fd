#include "importers/mesh/assimp_scene.h"

#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdio>

#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

constexpr double last_place = 1.2e-7;  // one unit in it, as a share: 2^-23

/// The file in memory, and files beside it that it names.
class FilesBeside : public Assimp::IOSystem
{
 public:
    FilesBeside(const MeshSource& source, std::string name) : source_(source), name_(std::move(name)) {}

    bool Exists(const char* name) const override { return name == name_ || !beside(name).empty(); }
    char getOsSeparator() const override { return '/'; }
    void Close(Assimp::IOStream* stream) override { delete stream; }

    Assimp::IOStream* Open(const char* name, const char*) override
    {
        if (name == name_) return stream_of(source_.bytes);
        const std::filesystem::path file = beside(name);
        try {
            return file.empty() ? nullptr : stream_of(read_bytes(file));
        } catch (const InputError&) {  // to assimp it is not there
            return nullptr;
        }
    }

 private:
    std::filesystem::path beside(std::string name) const
    {
        std::replace(name.begin(), name.end(), '\\', '/');
        const std::filesystem::path path(name);
        const bool leaves = path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
        const std::filesystem::path file = source_.path.parent_path() / path;
        std::error_code error;
        return !leaves && std::filesystem::is_regular_file(file, error) ? file : std::filesystem::path();
    }

    static Assimp::IOStream* stream_of(const std::string& bytes)
    {
        auto* copy = new std::uint8_t[bytes.size()];
        std::copy(bytes.begin(), bytes.end(), copy);
        return new Assimp::MemoryIOStream(copy, bytes.size(), true);
    }

    const MeshSource& source_;
    std::string name_;
};

Eigen::Affine3d affine(const aiMatrix4x4& m)
{
    Eigen::Affine3d transform;
    transform.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, 0, 0, 0, 1;
    return transform;
}

/// Takes the noise of 32-bit rotations away: what is almost 0, 1 or -1 is that.
Eigen::Affine3d without_noise(Eigen::Affine3d transform)
{
    for (double& entry : transform.linear().reshaped())
        if (std::abs(entry - std::round(entry)) < 1e-6) entry = std::round(entry);
    return transform;
}

Eigen::Affine3d without_signs(Eigen::Affine3d transform)
{
    transform.matrix() = transform.matrix().cwiseAbs().eval();
    return transform;
}

void append_mesh(const aiMesh& mesh, const std::string& place, PolygonSurface& surface)
{
    const std::size_t first = surface.vertices.size();
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
        surface.vertices.emplace_back(mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z);
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        std::vector<int>& face = surface.faces.emplace_back();
        for (unsigned i = 0; i < mesh.mFaces[f].mNumIndices; ++i)
            face.push_back(static_cast<int>(first) +
                           checked_index(mesh.mFaces[f].mIndices[i], mesh.mNumVertices, place));
    }
}

PolygonSurface surface_of(const aiNode& node, const aiScene& scene, const std::string& place)
{
    PolygonSurface surface;
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
        if (node.mMeshes[m] >= scene.mNumMeshes || scene.mMeshes[node.mMeshes[m]]->mVertices == nullptr) continue;
        append_mesh(*scene.mMeshes[node.mMeshes[m]], place, surface);
    }
    return surface;
}

/// Some importers call the root of a scene as the file.
bool is_name_of_file(const std::string& name, const MeshSource& source)
{
    return name.starts_with(source.path.stem().string() + ".");
}

/// Whether a transform only exchanges and turns axes.
bool keeps_digits(const Eigen::Affine3d& transform)
{
    const Eigen::Array33d entries = transform.linear().array().abs();
    return transform.translation().isZero(0) && (entries == 0 || entries == 1).all();
}

/// A node with the transforms of all that it hangs on.
struct PlacedNode {
    const aiNode* node;
    Eigen::Affine3d placement;
    Eigen::Affine3d magnitude;  // the same without signs: what nothing on the way can exceed
    std::string name;           // of the nearest node with one
};

}  // namespace

AssimpScene::AssimpScene(const MeshSource& source, const std::string& extension)
    : importer_(std::make_unique<Assimp::Importer>())
{
    const std::string name = source.path.stem().string() + "." + extension;
    importer_->SetIOHandler(new FilesBeside(source, name));
    importer_->SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    importer_->SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
    importer_->SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, false);
    importer_->SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_TEXTURES, false);
    scene_ = importer_->ReadFile(name, 0);
    if (scene_ != nullptr && scene_->mRootNode != nullptr && scene_->mNumMeshes > 0) return;
    std::string why = text::as_utf8(importer_->GetErrorString());
    while (!why.empty() && (why.back() == '\n' || why.back() == ' ' || why.back() == '.')) why.pop_back();
    std::string format = extension;
    for (char& c : format)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    throw InputError(
        source.place,
        "assimp reads no meshes from this " + format + " file" + (why.empty() ? "" : " (" + why + ")"),
        "export the stones as OBJ or glTF, one object each");
}

AssimpScene::~AssimpScene() = default;

std::optional<double> AssimpScene::number(const char* key) const
{
    const aiMetadata* data = scene_->mMetaData;
    std::int32_t whole = 0;
    float single = 0;
    double value = 0;
    if (data == nullptr) return {};
    if (data->Get(key, value)) return value;
    if (data->Get(key, single)) return single;
    return data->Get(key, whole) ? std::optional<double>(whole) : std::nullopt;
}

double seven_digits(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6e", value);
    return text::parse_number(text).value_or(value);
}

std::string own_name(const aiNode& node, const aiScene& scene)
{
    std::string name = node.mName.C_Str();
    name = name.substr(0, name.find("_$AssimpFbx$_"));
    const bool made_up =
        name.starts_with('<') || name.starts_with('$') || name.starts_with("nodes[") || name == "defaultobject";
    if (!name.empty() && !made_up) return name;
    const bool has_mesh = node.mNumMeshes > 0 && node.mMeshes[0] < scene.mNumMeshes;
    const std::string mesh = has_mesh ? scene.mMeshes[node.mMeshes[0]]->mName.C_Str() : "";
    return mesh == "defaultobject" ? "" : mesh;
}

MeshFile surfaces_of(const MeshSource& source, const aiScene& scene, const SceneReading& reading)
{
    SurfaceList result(source);
    double largest = 0;
    std::vector<PlacedNode> open{{scene.mRootNode, reading.to_file, without_signs(reading.to_file), ""}};
    while (!open.empty()) {
        const PlacedNode at = open.back();
        open.pop_back();
        const Eigen::Affine3d own = affine(at.node->mTransformation);
        const Eigen::Affine3d placement =
            reading.clean_transforms ? without_noise(at.placement * own) : at.placement * own;
        const Eigen::Affine3d magnitude = at.magnitude * without_signs(own);
        std::string own_words = reading.name_of(*at.node, scene);
        if (at.node == scene.mRootNode && is_name_of_file(own_words, source)) own_words.clear();
        const std::string name = own_words.empty() ? at.name : own_words;
        for (unsigned i = at.node->mNumChildren; i-- > 0;)
            open.push_back({at.node->mChildren[i], placement, magnitude, name});
        if (at.node->mNumMeshes == 0) continue;
        PolygonSurface surface = surface_of(*at.node, scene, source.place + ": " + name);
        surface.name = name;
        if (!reading.single || !keeps_digits(placement))
            for (const Eigen::Vector3d& x : surface.vertices)
                largest = std::max(largest, (magnitude * x.cwiseAbs().eval()).maxCoeff());
        result.add(std::move(surface), placement);
    }
    MeshFile file = result.finish();
    file.rounding = largest * last_place;
    return file;
}

}  // namespace voussoir::importers::mesh
