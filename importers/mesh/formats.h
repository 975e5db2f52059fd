// The readers of this folder, one for each format, and what they share. For read_mesh.cpp and the readers only.
#pragma once

#include <Eigen/Geometry>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "importers/mesh/polygon_surface.h"
#include "importers/mesh/read_mesh.h"

namespace voussoir::importers::mesh
{

/// A file in memory.
struct MeshSource {
    std::filesystem::path path;
    std::string place;  // the path as faults name it
    std::string name;   // of stones without one
    std::string bytes;  // text is UTF-8 without a byte order mark
};

/// Surfaces as a reader finds them. Names are made unique and surfaces without faces left out; both is reported.
class SurfaceList
{
 public:
    /// @param merge whether a surface with the name of another one is a part of it
    explicit SurfaceList(const MeshSource& source, bool merge = false)
        : place_(source.place), default_name_(source.name), merge_(merge)
    {
    }

    /// @param placement from the surface's axes to those of the file; where it mirrors, the faces are turned
    /// @throws InputError when a vertex is not finite or a face names a vertex that is not there
    void add(PolygonSurface surface, const Eigen::Affine3d& placement = Eigen::Affine3d::Identity());
    void note(std::string repair) { repairs_.push_back(std::move(repair)); }

    /// @throws InputError when there are no faces
    MeshFile finish();

 private:
    std::string unique(const std::string& wanted);
    void keep(PolygonSurface surface);

    std::string place_, default_name_;
    bool merge_;
    std::map<std::string, std::size_t> index_;  // of surfaces, when they are merged by name
    std::vector<PolygonSurface> surfaces_;
    std::vector<std::string> repairs_, renamed_, mirrored_;
    std::map<std::string, int> copies_;
    std::size_t faces_left_out_ = 0;
};

/// Adds the vertices and faces of one surface to another.
void append(const PolygonSurface& part, PolygonSurface& whole);

/// A number from unaligned bytes in either byte order.
template <class Number>
Number load(const char* at, bool big_endian = false)
{
    char bytes[sizeof(Number)];
    for (std::size_t i = 0; i < sizeof(Number); ++i) bytes[i] = at[big_endian ? sizeof(Number) - 1 - i : i];
    Number value;
    std::memcpy(&value, bytes, sizeof(Number));
    return value;
}

/// "a face names vertex 901" / "the mesh has 8 vertices". @throws InputError unless 0 <= index < count
int checked_index(long long index, std::size_t count, const std::string& place);

/// The whole content of a file. @throws InputError when there is none
std::string read_bytes(const std::filesystem::path& file);

MeshFile read_obj(const MeshSource& source, const ReadOptions& options);
MeshFile read_stl(const MeshSource& source);
MeshFile read_ply(const MeshSource& source);
MeshFile read_off(const MeshSource& source);
MeshFile read_compas(const MeshSource& source);
MeshFile read_gltf(const MeshSource& source);
MeshFile read_collada(const MeshSource& source);
MeshFile read_dxf(const MeshSource& source, const ReadOptions& options);
MeshFile read_3mf(const MeshSource& source);
MeshFile read_ifc(const MeshSource& source);

/// Any format that assimp reads, by the extension that it knows it by.
MeshFile read_assimp(const MeshSource& source, const std::string& extension);

/// Whether binary STL is meant: the count in the header fits the length of the file.
bool is_binary_stl(std::string_view bytes);

/// The parts of a zip archive whose names end in `ending`, by name.
/// @throws InputError when the archive is damaged or unpacks to more than 1 GiB
std::map<std::string, std::string> unzipped(const MeshSource& archive, const std::string& ending);

/// The same file with the content of the part whose name ends in `ending`.
/// @throws InputError when there is none, or as above
MeshSource unpacked(const MeshSource& archive, const std::string& ending);

}  // namespace voussoir::importers::mesh
