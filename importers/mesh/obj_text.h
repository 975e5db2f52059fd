// The text of an OBJ file, made ready for a reader that rounds coordinates and merges equal names.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace voussoir
{

/// A run of faces between two `o` or `g` lines.
struct ObjSegment {
    int stone = 0;  // index into ObjText::stone_names
    std::size_t faces = 0, corners = 0;
};

/// An OBJ file as handed on: the structure in a form that survives the reader, the numbers in double beside it.
struct ObjText {
    std::string structure;  // vertex k is written "v low high 0" (vertex_number), segment s is the object "s"
    std::vector<Eigen::Vector3d> vertices;  // every `v` line, in full precision
    std::vector<ObjSegment> segments;
    std::vector<std::string> stone_names;  // unique
    std::vector<std::string> repairs;
};

/// The vertex that the coordinates (low, high) of a structure text stand for; exact in 32-bit numbers.
std::size_t vertex_number(double low, double high);

/// Re-reads the `v`, `f`, `o` and `g` lines of an OBJ file; normals, textures, materials, lines and points are
/// left out. @param place names the file in faults; @param default_name for faces before the first object
/// @throws InputError with all faults and their lines (at most twenty): a coordinate that is not a finite number,
/// a face of fewer than three corners, an index that names no vertex, no faces at all
ObjText read_obj_text(std::string_view text, const std::string& place, const std::string& default_name);

}  // namespace voussoir
