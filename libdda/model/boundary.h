// Where the model ends within the ground: faces that let waves out and in.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "libdda/model/ground_motion.h"

namespace voussoir
{

/// A face of a part of a block; in a planar scene an edge of its outline, from a corner to the next.
struct BlockFace {
    int block = 0;  // index into Model::blocks
    int part = 0;   // of the block
    int face = 0;   // of the part
};

/// What carries the faces of a boundary in static stages, and with what was reached there ever after.
enum class RestSupport {
    full,    // stiff springs in every direction
    normal,  // along the normal only: rollers
    none,    // nothing
};

/// Faces with dashpots of the impedance of their own block: rho c_p along the normal, rho c_s across it.
/// Source: [LysmerKuhlemeyer1969].
struct ViscousBoundary {
    std::string name;                         // as in the case file
    std::vector<BlockFace> faces;             // of deformable blocks that are not held
    RestSupport at_rest = RestSupport::full;  // what carries the faces until the motion begins
    // One per face, of Model::tied_sides: ground that moves as it would without the model. Dashpots are between
    // the two, and its stress presses on the face; it feels nothing of that. Empty: dashpots against ground at
    // rest
    std::vector<int> free_field = {};
};

/// Two faces, one a copy of the other somewhere else, that are bonded as if they were in one place: opposite sides
/// of a model that repeats itself. The bond neither slides nor breaks.
struct SideTie {
    BlockFace a, b;     // of two deformable blocks that are not held
    double normal = 0;  // Pa/m, along the normal of the drawn face
    double shear = 0;   // Pa/m, across it
};

/// A plane wave that comes in through a boundary.
struct IncomingWave {
    int boundary = 0;                                    // index into Model::boundaries
    int component = 0;                                   // 0, 1, 2: x, y, z: of the particles
    std::shared_ptr<const GroundMotion> motion;          // of which `share` is the motion of the wave by itself
    double share = 1;                                    // -, 1/2 where the motion is that of an outcrop
    Eigen::Vector3d slowness = Eigen::Vector3d::Zero();  // s/m, how much later it comes along each axis
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();    // m, where it comes when the motion says
};

}  // namespace voussoir
