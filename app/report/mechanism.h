// How a structure moved, or failed: which joints turned, slid or parted, and which stones moved as one.
#pragma once

#include <optional>
#include <vector>

#include "app/report/course.h"

namespace voussoir::app::report
{

/// What a joint did by the moment that is described.
struct MovedJoint {
    int joint = 0;                                   // of the model
    double opening = 0, slip = 0;                    // m, largest over it
    double turn = 0;                                 // rad, of the one block against the other
    bool opens = false, slides = false;              // one of them at least
    bool parted = false;                             // it opens and presses nowhere
    Eigen::Vector3d edge = Eigen::Vector3d::Zero();  // unit, in the joint: from its middle to where it turns
};

/// Stones between which no joint opened or slid worth mentioning.
struct Body {
    std::vector<int> blocks;
    bool rests = false;            // holds a foundation, or is the largest where there is none, or stays
    bool stays = false;            // moved, but at the end is near its place while others have moved off
    double displacement = 0;       // m, the largest of its stones
    double last_displacement = 0;  // m, at the end of the run
    double turn = 0;               // rad, the largest of its stones
    double last_turn = 0;          // rad, at the end of the run
};

enum class MechanismKind {
    stands,     // whatever opened or slid, it did not move off
    hinges,     // bodies between hinges, each turning on two or more
    slides,     // along its joints, by far more than they open
    overturns,  // bodies that turn about one edge each
    sheds,      // what is above comes off, what is below stays
    mixed,      // turning and sliding
    loose,      // what moved off was held by no joint at the start: tossed, leaning
};

struct Mechanism {
    MechanismKind kind = MechanismKind::stands;
    double time = 0;                          // s, of the moment that is described
    std::size_t frame = 0;                    // the stored frame of it
    std::vector<MovedJoint> joints;           // from the most to the least moved
    std::vector<Body> bodies;                 // the resting ones first, then the largest first
    double opening = 0, slip = 0;             // m, sums over those joints
    int hinges = 0, sliding = 0, parted = 0;  // pairs of bodies that turn on each other, slide, have come apart
    bool goes_on = false;                     // how it ends is not known: stones moved, or it ended before its end
};

/// A structure that stands is described at the moment of its largest opening or slip; one that does not while it
/// begins to go: the last frame in which no stone has moved further than a quarter of its size. Of joints those
/// count that moved more than 0.1 mm and more than a tenth of what moved most.
/// @param results with a frame; @param failed by the run's verdict, or as it ended; nothing: not known, and what
/// has gone further than a quarter of a stone has failed
Mechanism mechanism_in(const results::ResultsReader& results, const Course& course, std::optional<bool> failed);

}  // namespace voussoir::app::report
