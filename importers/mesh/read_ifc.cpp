#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdio>
#include <memory>

#include "importers/mesh/step_text.h"
#include "importers/mesh/text.h"

namespace voussoir
{

namespace
{

Eigen::Affine3d affine(const aiMatrix4x4& m)
{
    Eigen::Affine3d transform;
    transform.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3,
        m.d4;
    return transform;
}

/// The decimal number that a 32-bit number stood for.
double seven_digits(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6e", value);
    return parse_number(text).value_or(value);
}

/// Takes the noise of 32-bit rotations away: what is almost 0, 1 or -1 is that.
Eigen::Affine3d without_noise(Eigen::Affine3d transform)
{
    for (double& entry : transform.linear().reshaped())
        if (std::abs(entry - std::round(entry)) < 1e-6) entry = std::round(entry);
    return transform;
}

const aiScene& parse(Assimp::Importer& importer, const MeshSource& source)
{
    const aiScene* scene = importer.ReadFileFromMemory(source.bytes.data(), source.bytes.size(), 0, "ifc");
    if (scene != nullptr && scene->mRootNode != nullptr && scene->mNumMeshes > 0) return *scene;
    std::string why = importer.GetErrorString();
    while (!why.empty() && (why.back() == '\n' || why.back() == ' ' || why.back() == '.')) why.pop_back();
    throw InputError(source.place,
                     "no solids could be read from this IFC file" + (why.empty() ? "" : " (" + why + ")"),
                     "export the stones as OBJ, one object each");
}

/// "IfcWallStandardCase_south wall_3fx1..." is made by assimp of the type, name and identifier of a product.
PolygonSurface surface_of(const aiNode& node, const aiScene& scene)
{
    PolygonSurface surface{node.mName.C_Str(), {}, {}};
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
        const int first = static_cast<int>(surface.vertices.size());
        for (unsigned v = 0; v < mesh.mNumVertices; ++v)
            surface.vertices.emplace_back(mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z);
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            std::vector<int>& face = surface.faces.emplace_back();
            for (unsigned i = 0; i < mesh.mFaces[f].mNumIndices; ++i)
                face.push_back(first + static_cast<int>(mesh.mFaces[f].mIndices[i]));
        }
    }
    return surface;
}

}  // namespace

MeshFile read_ifc(const MeshSource& source)
{
    check_step_text(source);
    Assimp::Importer importer;
    const aiScene& scene = parse(importer, source);
    // assimp's root turns the scene to y up and scales it to metres: both are taken back.
    const Eigen::Affine3d root = affine(scene.mRootNode->mTransformation);
    const double metres_per_unit = seven_digits(std::cbrt(std::abs(root.linear().determinant())));
    if (!(metres_per_unit > 0))
        throw InputError(source.place, "its unit of length is zero", "correct its IfcUnitAssignment");
    Eigen::Affine3d to_file = Eigen::Affine3d::Identity();
    to_file.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    to_file.linear() /= metres_per_unit;

    SurfaceList result(source);
    double largest = 0;
    std::vector<std::pair<const aiNode*, Eigen::Affine3d>> open{{scene.mRootNode, to_file}};
    while (!open.empty()) {
        const auto [node, parent] = open.back();
        open.pop_back();
        const Eigen::Affine3d placement = without_noise(parent * affine(node->mTransformation));
        for (unsigned i = node->mNumChildren; i-- > 0;) open.emplace_back(node->mChildren[i], placement);
        if (node->mNumMeshes == 0) continue;
        PolygonSurface surface = surface_of(*node, scene);
        for (const Eigen::Vector3d& x : surface.vertices) {
            const Eigen::Vector3d placed = placement * x;
            largest = std::max({largest, x.cwiseAbs().maxCoeff(), placed.cwiseAbs().maxCoeff()});
        }
        result.add(std::move(surface), placement);
    }
    MeshFile file = result.finish();
    file.metres_per_unit = metres_per_unit;
    file.up = 'z';
    file.rounding = largest * 6e-8 * 2;  // half a unit in the last place of 32-bit numbers, points and transforms
    return file;
}

}  // namespace voussoir
