// The parts of a bridge, added to its pattern one after another.
#pragma once

#include "importers/patterns/bridge.h"
#include "importers/patterns/bridge_profile.h"

namespace voussoir::importers::patterns
{

/// Neighbouring arches that are alike, and what stands on them: from an end of the bridge, or the middle of a
/// pier, to another. Its regions are what stands before, between and behind its arches below their backs.
struct Bay {
    int first = 0, arches = 1;   // from 0, of the bridge; how many
    int first_region = 0;        // of the bridge, from 0
    double left = 0, right = 0;  // m, along x
    BridgeProfile profile;       // of each of its arches, with beds up to the highest backs of the bridge

    int end() const { return first + arches; }
};

/// A bridge while it is built.
struct BridgeWork {
    const Bridge& bridge;
    std::vector<double> middles;  // m, of the arches
    std::vector<Bay> bays;
    std::vector<double> through;  // m, beds of the courses over all arches, up to the road
    Pattern pattern;

    int spans() const { return static_cast<int>(bridge.arches.size()); }
    double left_end() const;   // m
    double right_end() const;  // m
    double road() const { return through.back(); }
    /// The middle of the pier behind an arch [m].
    double pier_middle(int arch) const;
    const Bay& bay_of(int arch) const;
    /// Number of the first course over all arches, from 0.
    int first_through() const;
    /// How many courses of a bay belong to the backing.
    int backing_courses(const Bay& bay) const;
    double inner() const { return bridge.width / 2 - bridge.spandrel_thickness; }  // half the width of the fill

    /// Beginning and end of a course in a region of a bay (from 0), or of the whole bay above its arches [m].
    std::pair<double, double> reach(const Bay& bay, int region, int course) const;
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
