// A file as assimp reads it, and the surfaces that it holds. assimp computes with 32-bit numbers and does not
// survive every damaged file, which is why files are read in the limited child process of importers/helper only.
#pragma once

#include <functional>
#include <memory>

#include "importers/mesh/formats.h"

struct aiNode;
struct aiScene;
namespace Assimp
{
class Importer;
}

namespace voussoir::importers::mesh
{

class AssimpScene
{
 public:
    /// Reads what is in memory; other files that it names are looked for beside the file, nowhere else.
    /// @param extension of the format, without a point: what assimp chooses its importer by
    /// @throws InputError when assimp cannot read it, or finds no meshes
    AssimpScene(const MeshSource& source, const std::string& extension);
    ~AssimpScene();

    const aiScene& operator*() const { return *scene_; }

    /// A number that the file says of itself, under the name that assimp gives it.
    std::optional<double> number(const char* key) const;

 private:
    std::unique_ptr<Assimp::Importer> importer_;
    const aiScene* scene_ = nullptr;
};

/// The decimal number that a 32-bit number stood for.
double seven_digits(double value);

/// How a scene is taken.
struct SceneReading {
    Eigen::Affine3d to_file = Eigen::Affine3d::Identity();  // from assimp's axes and unit to those of the file
    bool clean_transforms = false;                          // whether entries that are almost 0, 1 or -1 are that
    bool single = false;  // whether the file itself holds 32-bit numbers: those that are not moved are exact
    // The name of a node with meshes; empty: that of the node it hangs on, else of the file.
    std::function<std::string(const aiNode&, const aiScene&)> name_of;
};

/// The name of a node, or else of its first mesh; names that assimp makes up are none.
std::string own_name(const aiNode& node, const aiScene& scene);

/// One surface for every node with meshes, its transforms applied in double precision. `rounding` is one unit in
/// the last place of 32-bit numbers, half of it for coordinates and half for transforms, of the largest number
/// that is met on the way.
/// @throws InputError when the scene holds no faces or names vertices that are not there
MeshFile surfaces_of(const MeshSource& source, const aiScene& scene, const SceneReading& reading);

}  // namespace voussoir::importers::mesh
