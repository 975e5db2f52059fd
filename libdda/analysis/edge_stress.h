// The stress at the edge of a joint, from its resultant.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace voussoir
{

/// A corner of a contact polygon, in space.
struct BedPoint {
    Eigen::Vector3d position;  // m
    double area = 0;           // m2, tributary
    double normal_force = 0;   // N, > 0 pressing
};

/// The plane of a face in the reference shape of its own block, where faces do not rock.
struct FacePlane {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();  // m
};

/// One contact patch of a joint.
struct BedPatch {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit, as it is now
    std::array<FacePlane, 2> faces;                    // that the two blocks bring to it
    bool edge_edge = false;                            // has no faces
    std::vector<BedPoint> points;                      // a polygon in turn, and then what is inside
    std::size_t inner = 0;                             // of the points are inside
};

/// What bears most.
struct Bearing {
    double stress = 0;  // Pa
    double area = 0;    // m2, of the part that the normal force acts in the middle of
};

/// The largest edge stress of the beds of a joint. A bed is all patches whose faces lie in one plane on either of
/// the blocks; stones glued of several parts may meet in several.
///
/// The edge stress is the mean on the part of a bed that its normal force acts in the middle of. Of a rectangular
/// bed b x l with eccentricities e: N / ((b - 2 e_b) (l - 2 e_l)). Source: [Meyerhof1953], as in
/// [EN1996-1-1-2005], 6.1.2.2; of other shapes with b and l the sides of the smallest rectangle around them, times
/// the share of it that they fill. It is the stress block of a toe that yields: where the stress equals the
/// strength, no block of that strength that fits the bed carries more with this resultant. A bed that bears on its
/// edge or its corner bears on a tenth of its area (ibid., annex C (4), which says so of walls): corner springs
/// put the resultant of a rocking stone on the very edge, where any force would crush. There the toe is as large
/// as the strength makes it, and what is judged is whether it would need more than that tenth. Patches that have
/// opened so far that contacts are no longer looked for do not count, and a bed that has lost some bears on a
/// tenth of the rest: there the stress errs upwards.
/// @param size of the smaller block [m]
Bearing hardest_bearing(const std::vector<BedPatch>& patches, double size);

}  // namespace voussoir
