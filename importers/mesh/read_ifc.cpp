#include <assimp/scene.h>

#include <cmath>

#include "importers/mesh/assimp_scene.h"
#include "importers/mesh/step_text.h"
#include "libdda/errors.h"

namespace voussoir::importers::mesh
{

namespace
{

/// The length of assimp's unit, the metre, in the file's: by the volume that its root gives a unit cube.
double metres_of_root(const aiMatrix4x4& root)
{
    Eigen::Matrix3d linear;
    linear << root.a1, root.a2, root.a3, root.b1, root.b2, root.b3, root.c1, root.c2, root.c3;
    return seven_digits(std::cbrt(std::abs(linear.determinant())));
}

/// "IfcWallStandardCase_south wall_3fx1..." is made by assimp of the type, name and identifier of a product.
std::string product_name(const aiNode& node, const aiScene&)
{
    return node.mName.C_Str();
}

}  // namespace

MeshFile read_ifc(const MeshSource& source)
{
    check_step_text(source);
    const AssimpScene scene(source, "ifc");
    // assimp's root turns the scene to y up and scales it to metres: both are taken back.
    const double metres_per_unit = metres_of_root((*scene).mRootNode->mTransformation);
    if (!(metres_per_unit > 0))
        throw InputError(source.place, "its unit of length is zero", "correct its IfcUnitAssignment");
    SceneReading reading;
    reading.to_file.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    reading.to_file.linear() /= metres_per_unit;
    reading.clean_transforms = true;
    reading.name_of = product_name;
    MeshFile file = surfaces_of(source, *scene, reading);
    file.metres_per_unit = metres_per_unit;
    file.up = 'z';
    return file;
}

}  // namespace voussoir::importers::mesh
