#include "importers/mesh/read_mesh.h"

#include <assimp/scene.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "importers/mesh/obj_text.h"
#include "libdda/errors.h"

namespace voussoir
{

namespace
{

using Node = std::pair<const aiNode*, aiMatrix4x4>;  // with its transform to the file's own axes

std::string read_text(const std::filesystem::path& file)
{
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status))
        throw InputError(file.string(), "there is no such file", "give the path of a mesh file");
    if (!std::filesystem::is_regular_file(status))
        throw InputError(file.string(), "this is not a file", "give the path of a mesh file");
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream) throw InputError(file.string(), "the file cannot be read", "check its permissions");
    if (text.empty()) throw InputError(file.string(), "the file is empty", "a mesh file has vertices and faces");
    return text;
}

const aiScene* parse(Assimp::Importer& importer, const std::string& text, const std::string& format,
                     const std::string& place)
{
    const aiScene* scene = importer.ReadFileFromMemory(text.data(), text.size(), 0, format.c_str());
    if (scene != nullptr && scene->mRootNode != nullptr && scene->mNumMeshes > 0) return scene;
    std::string why = importer.GetErrorString();
    while (!why.empty() && (why.back() == '\n' || why.back() == ' ' || why.back() == '.')) why.pop_back();
    throw InputError(place, "this is not a readable " + format + " mesh" + (why.empty() ? "" : " (" + why + ")"),
                     "give an OBJ, STL, PLY or OFF file with faces");
}

std::vector<Node> nodes_with_meshes(const aiScene& scene)
{
    std::vector<Node> open{{scene.mRootNode, aiMatrix4x4()}}, found;
    while (!open.empty()) {
        const auto [node, parent] = open.back();
        open.pop_back();
        const aiMatrix4x4 transform = parent * node->mTransformation;
        if (node->mNumMeshes > 0) found.emplace_back(node, transform);
        for (unsigned i = node->mNumChildren; i-- > 0;) open.emplace_back(node->mChildren[i], transform);
    }
    return found;
}

/// Faces as assimp holds them, checked: every index names a vertex of the mesh.
std::vector<std::vector<int>> faces_of(const aiMesh& mesh, const std::string& place)
{
    std::vector<std::vector<int>> faces;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        faces.emplace_back(face.mIndices, face.mIndices + face.mNumIndices);
        for (const int v : faces.back())
            if (v < 0 || static_cast<unsigned>(v) >= mesh.mNumVertices)
                throw InputError(place, "a face names vertex " + std::to_string(v),
                                 "the mesh has " + std::to_string(mesh.mNumVertices) + " vertices");
    }
    return faces;
}

/// Puts the double coordinates back: every corner carries the number of its `v` line.
class ObjAssembler
{
 public:
    ObjAssembler(const ObjText& obj, std::string place)
        : obj_(obj),
          place_(std::move(place)),
          surfaces_(obj.stone_names.size()),
          local_(surfaces_.size()),
          faces_(obj.segments.size(), 0),
          corners_(obj.segments.size(), 0)
    {
        for (std::size_t i = 0; i < surfaces_.size(); ++i) surfaces_[i].name = obj.stone_names[i];
    }

    void add(const aiNode& node, const aiScene& scene)
    {
        const std::size_t segment = std::strtoul(node.mName.C_Str(), nullptr, 10);
        if (segment >= obj_.segments.size()) disagree();
        for (unsigned m = 0; m < node.mNumMeshes; ++m) {
            const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
            for (const std::vector<int>& face : faces_of(mesh, place_)) add_face(mesh, face, segment);
        }
    }

    std::vector<PolygonSurface> finish()
    {
        for (std::size_t s = 0; s < obj_.segments.size(); ++s)
            if (faces_[s] != obj_.segments[s].faces || corners_[s] != obj_.segments[s].corners) disagree();
        std::erase_if(surfaces_, [](const PolygonSurface& surface) { return surface.faces.empty(); });
        return std::move(surfaces_);
    }

 private:
    void add_face(const aiMesh& mesh, const std::vector<int>& face, std::size_t segment)
    {
        const int stone = obj_.segments[segment].stone;
        PolygonSurface& surface = surfaces_[stone];
        std::vector<int> loop;
        for (const int corner : face) {
            const aiVector3D& code = mesh.mVertices[corner];
            const std::size_t number = vertex_number(code.x, code.y);
            if (number >= obj_.vertices.size()) disagree();
            const auto [entry, is_new] = local_[stone].emplace(number, static_cast<int>(surface.vertices.size()));
            if (is_new) surface.vertices.push_back(obj_.vertices[number]);
            loop.push_back(entry->second);
        }
        faces_[segment] += 1;
        corners_[segment] += loop.size();
        surface.faces.push_back(std::move(loop));
    }

    [[noreturn]] void disagree() const
    {
        throw InputError(place_, "two readings of the file disagree about its objects, faces or corners",
                         "write each face as `f a b c ...` after its vertices");
    }

    const ObjText& obj_;
    std::string place_;
    std::vector<PolygonSurface> surfaces_;
    std::vector<std::map<std::size_t, int>> local_;  // per stone: number of the `v` line -> vertex of the surface
    std::vector<std::size_t> faces_, corners_;       // per segment, as assimp gave them
};

MeshFile read_obj(const std::string& text, const std::filesystem::path& file)
{
    const ObjText obj = read_obj_text(text, file.string(), file.stem().string());
    Assimp::Importer importer;
    const aiScene* scene = parse(importer, obj.structure, "obj", file.string());
    ObjAssembler assembler(obj, file.string());
    for (const Node& node : nodes_with_meshes(*scene)) assembler.add(*node.first, *scene);
    return {assembler.finish(), 0, obj.repairs};
}

/// Appends a mesh of a node; faces that assimp reduced to points or lines are counted and left out.
std::size_t append(const aiMesh& mesh, const aiMatrix4x4& transform, const std::string& place,
                   PolygonSurface& surface)
{
    const int first = static_cast<int>(surface.vertices.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const aiVector3D x = transform * mesh.mVertices[v];
        if (!std::isfinite(x.x) || !std::isfinite(x.y) || !std::isfinite(x.z))
            throw InputError(place, "vertex " + std::to_string(v) + " is not finite", "coordinates are numbers");
        surface.vertices.emplace_back(x.x, x.y, x.z);
    }
    std::size_t left_out = 0;
    for (std::vector<int> face : faces_of(mesh, place)) {
        for (int& v : face) v += first;
        if (face.size() < 3)
            ++left_out;
        else
            surface.faces.push_back(std::move(face));
    }
    return left_out;
}

std::string name_of(const aiNode& node, const aiScene& scene, const std::string& fallback)
{
    std::string mesh = scene.mMeshes[node.mMeshes[0]]->mName.C_Str();
    const std::string own = node.mName.C_Str();
    if (!mesh.empty()) return mesh;
    return own.empty() || own.front() == '<' ? fallback : own;  // "<STL_BINARY>" and the like are assimp's words
}

MeshFile read_by_assimp(const std::string& text, const std::string& format, const std::filesystem::path& file)
{
    Assimp::Importer importer;
    const aiScene* scene = parse(importer, text, format, file.string());
    MeshFile mesh;
    std::set<std::string> taken;
    double largest = 0;
    for (const auto& [node, transform] : nodes_with_meshes(*scene)) {
        const std::string wanted = name_of(*node, *scene, file.stem().string());
        PolygonSurface surface{wanted, {}, {}};
        for (int copy = 2; !taken.insert(surface.name).second; ++copy)
            surface.name = wanted + " (" + std::to_string(copy) + ")";
        std::size_t left_out = 0;
        for (unsigned m = 0; m < node->mNumMeshes; ++m)
            left_out += append(*scene->mMeshes[node->mMeshes[m]], transform, file.string(), surface);
        if (left_out > 0)
            mesh.repairs.push_back(std::to_string(left_out) + " faces of \"" + surface.name +
                                   "\" have fewer than three corners and were left out");
        for (const Eigen::Vector3d& x : surface.vertices) largest = std::max(largest, x.cwiseAbs().maxCoeff());
        if (!surface.faces.empty()) mesh.surfaces.push_back(std::move(surface));
    }
    if (mesh.surfaces.empty())
        throw InputError(file.string(), "the file holds no faces", "a stone is a closed surface");
    mesh.rounding = largest * 6e-8;  // half a unit in the last place of a 32-bit number
    return mesh;
}

}  // namespace

MeshFile read_mesh(const std::filesystem::path& file)
{
    std::string format = file.extension().string();
    std::transform(format.begin(), format.end(), format.begin(), [](unsigned char c) { return std::tolower(c); });
    const std::string text = read_text(file);
    if (format == ".obj") return read_obj(text, file);
    if (format == ".stl" || format == ".ply" || format == ".off")
        return read_by_assimp(text, format.substr(1), file);
    throw InputError(file.string(), "meshes of this kind (\"" + format + "\") are not read yet",
                     "convert it to OBJ, STL, PLY or OFF");
}

}  // namespace voussoir
