// Geometry from mesh files, read and certified in a child process under time and memory limits: a reader that
// crashes or hangs is a refusal with a reason. Neither assimp nor CGAL is loaded into the program that asks.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "importers/helper/placed_copy.h"
#include "importers/helper/stone_choice.h"
#include "importers/mesh/marked_feature.h"
#include "importers/mesh/mesh_formats.h"
#include "importers/mesh/repair.h"
#include "libdda/geometry/convex_polyhedron.h"
#include "libdda/geometry/moments.h"

namespace voussoir::importers::helper
{

/// One stone of a mesh file with its certificate.
struct Stone {
    std::string name;                     // as the file names it
    bool closed = false, convex = false;  // proven
    std::string reason;                   // why it was refused; empty when accepted
    std::string cure;                   // of a refused one: the key that would help, "hull", "simplify" or "skip"
    std::vector<mesh::Repair> repairs;  // every repair that was made
    // In metres, z up, model coordinates (origin subtracted); empty when refused.
    std::vector<ConvexPolyhedron> parts;
    Moments moments;          // of the stone as drawn, m; volume 0: it encloses none
    double volume_error = 0;  // share of the volume by which approximating parts differ from it; 0: exact
    double fit_move = 0;      // m: largest move of a corner, to fit its joints; 0: as drawn
    double fit_volume_change =
        0;  // share of the volume as drawn by which that changed it; its moments are as drawn
    std::vector<mesh::MarkedFeature> features;  // what is wrong where; empty when nothing is
    // The surface as it was judged, for pictures; sent for stones with features only.
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::vector<int>> faces;  // its vertex loops
};

/// What a mesh file gave.
struct ImportedMesh {
    std::string file;                         // its name
    bool accepted = false;                    // every stone of it
    std::string reason;                       // why the file was refused; empty when accepted
    double metres_per_unit = 1;               // of its coordinates
    std::string unit_from = "assumed";        // or "file", "option"
    std::vector<mesh::Repair> repairs;        // of the file
    std::vector<Stone> stones;                // in the order of the file
    std::vector<SkippedStone> skipped;        // left out by choice
    std::vector<UnmatchedPattern> unmatched;  // patterns of the request that no stone has the name of
};

/// Two stones that overlap by more than the tolerance.
struct Overlap {
    std::string stone_a, stone_b;  // names
    double volume = 0;             // m3
    double fraction = 0;           // of the smaller stone's volume
};

/// What fitting joints came to.
struct JointFit {
    int joints = 0, left = 0;                    // that did not fit: fitted, left as drawn
    double misfit_before = 0, misfit_after = 0;  // m: largest overlap or gap between the sides of a joint
};

/// What the helper answers.
struct Geometry {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // m, subtracted from all coordinates
    std::vector<ImportedMesh> meshes;                  // one per request
    std::vector<Overlap> overlaps;                     // between stones of all of them
    JointFit fit;                                      // of all of them
};

/// What becomes one stone. `detect` takes objects, or groups where there are none, and takes a surface that
/// consists of several closed shells apart; so do `file` and `component`.
enum class StoneLevel { detect, file, object, group, node, component };

/// The names above, in their order.
extern const std::vector<std::string> stone_level_names;

/// The names of MeshReader's values, in their order.
extern const std::vector<std::string> mesh_reader_names;

/// What becomes of joints whose two sides were drawn differently: nothing; one plane where they are warped; one
/// plane for all, flat ones that overlap and those that both sides bend alike among them.
enum class FitJoints { as_drawn, shared, planar };

/// The names above, in their order.
extern const std::vector<std::string> fit_joints_names;

/// A mesh file to be read and certified.
struct MeshRequest {
    std::filesystem::path file;  // to be read
    double metres_per_unit = 0;  // 0: as the file says, metres if it does not
    char up = 0;                 // axis of the file that points up, 'x', 'y' or 'z'; 0: as the file says, else z
    StoneLevel stones = StoneLevel::detect;  // what becomes one stone
    double planarity = 1e-5;     // share of a stone's diagonal by which a face may bulge and count as flat
    double volume_error = 0.01;  // share of a concave stone's volume by which approximating parts may exceed it
    FitJoints fit_joints = FitJoints::shared;  // what becomes of joints whose two sides were drawn differently
    double close_joints = 0;  // m: facing faces that stand apart by at most this are moved together
    mesh::MeshReader reader = mesh::MeshReader::automatic;
    std::vector<PlacedCopy> copies = {};  // where its stones stand, metres and z up; none: once, as drawn
    StoneChoice choice = {};              // which stones are taken
    StoneSimplification simplify = {};    // how scans become stones
};

/// What the helper may take.
struct GeometryLimits {
    double seconds = 30;                       // of wall time
    std::size_t bytes = std::size_t{2} << 30;  // of memory
};

/// Starts the helper program `voussoir-geometry` (beside the running program), hands it the request, reads its
/// answer. Refusals are in the answer; a helper that dies, hangs or answers nonsense is a refusal of the files
/// with the reason.
Geometry import_geometry(const std::vector<MeshRequest>& requests, const GeometryLimits& limits);

/// The formats that the helper reads. @throws std::runtime_error when it gives no answer
std::vector<mesh::MeshFormat> list_mesh_formats();

}  // namespace voussoir::importers::helper
