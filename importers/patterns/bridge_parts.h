// The parts of a bridge, added to its pattern one after another.
#pragma once

#include <functional>

#include "importers/patterns/bridge_profile.h"

namespace voussoir::importers::patterns
{

/// A bridge while it is built.
struct BridgeWork {
    const Bridge& bridge;
    BridgeProfile profile;
    Pattern pattern;

    /// The middle of an arch, from 0 [m].
    double middle(int arch) const
    {
        return to_nanometre((arch - (bridge.spans - 1) / 2.0) * (bridge.curve.span + bridge.pier_width));
    }
    double left_end() const { return to_nanometre(middle(0) - bridge.curve.span / 2 - bridge.abutment_length); }
    double road() const { return profile.beds.back(); }
    /// Beginning and end of a course between arches: region 0 is before the first arch, `spans` after the
    /// last. From end to end above the arches.
    std::pair<double, double> reach(int region, int course) const;
    /// How many courses of the backing there are.
    int backing_courses() const;
    double inner() const { return bridge.width / 2 - bridge.spandrel_thickness; }  // half the width of the fill
};

void add_arches(BridgeWork& work);
void add_abutments(BridgeWork& work);
void add_piers(BridgeWork& work);
void add_spandrels(BridgeWork& work);
void add_backing_and_fill(BridgeWork& work);
void add_parapets(BridgeWork& work);

/// Adds a box. @param lower, upper corners [m]
void add_box(Pattern& pattern, const std::string& name, const std::string& group, const Eigen::Vector3d& lower,
             const Eigen::Vector3d& upper);

/// "_c03_b12".
std::string course_and_block(int course, int block);

}  // namespace voussoir::importers::patterns
