#include "importers/patterns/bridge_profile.h"

#include <algorithm>
#include <cmath>

namespace voussoir::importers::patterns
{
namespace
{

constexpr double least_step = 0.6;  // of a course

/// The joint until it meets a level.
void raise(ArchJoint& joint, double level)
{
    if (joint.extrados.y() == level) return;
    const Point way = joint.extrados - joint.intrados;
    joint.extrados = {to_nanometre(joint.intrados.x() + way.x() * (level - joint.intrados.y()) / way.y()), level};
}

/// The levels of the backs of the left half; `of_joint` gets the level of each joint.
std::vector<double> levels_of(const std::vector<ArchJoint>& joints, double step, std::vector<int>& of_joint)
{
    const int crown = static_cast<int>(joints.size() - 1) / 2;
    std::vector<double> levels{joints[0].extrados.y()};
    of_joint.assign(joints.size(), 0);
    int first = 1;  // of the joints that have no level yet
    for (int i = 1; i <= crown; ++i) {
        const double level = joints[i].extrados.y();
        const bool is_high = level - levels.back() >= step;
        if (!is_high && i < crown) continue;
        if (is_high || levels.size() == 1)
            levels.push_back(level);
        else
            levels.back() = level;
        for (; first <= i; ++first) of_joint[first] = static_cast<int>(levels.size()) - 1;
    }
    for (std::size_t i = 0; i < joints.size(); ++i) of_joint[joints.size() - 1 - i] = of_joint[i];
    return levels;
}

void add_courses(std::vector<double>& beds, double to, double height)
{
    const double from = beds.back();
    const int count = std::max(1, static_cast<int>(std::lround((to - from) / height)));
    for (int i = 1; i < count; ++i) beds.push_back(to_nanometre(from + (to - from) * i / count));
    beds.push_back(to);
}

/// A thin voussoir below a high step has a hollow side.
void check_convex(const BridgeProfile& profile, int voussoirs)
{
    try {
        for (int i = 0; i < voussoirs; ++i) prism_along_y(profile.outline(i), 0, 1, "voussoir");
    } catch (const InputError&) {
        throw InputError("thickness", "a voussoir with its stepped back would not be convex",
                         "give a greater thickness, more voussoirs or lower blocks");
    }
}

}  // namespace

void BridgeProfile::carry_on(double level, double height)
{
    if (level > beds.back()) add_courses(beds, level, height);
}

double BridgeProfile::end_of_course(int course) const
{
    std::size_t joint = 0;
    while (bed_of_joint[joint + 1] <= course) ++joint;
    return joints[joint].extrados.x();
}

std::vector<Point> BridgeProfile::outline(int voussoir) const
{
    const ArchJoint &left = joints[voussoir], &right = joints[voussoir + 1];
    const double level = beds[bed_of_back(voussoir)];
    return {left.intrados,  left.extrados, {left.extrados.x(), level}, {right.extrados.x(), level},
            right.extrados, right.intrados};
}

BridgeProfile profile_of(const ArchCurve& curve, double course, double crown_level)
{
    BridgeProfile profile;
    profile.joints = joints_of(curve);
    const int crown = curve.voussoirs / 2;
    for (int i = 0; i < crown; ++i)
        if (profile.joints[i + 1].extrados.y() < profile.joints[i].extrados.y())
            throw InputError("springing_thickness", "the backs of the voussoirs do not rise to the crown",
                             "give a smaller springing_thickness");
    std::vector<int> level_of_joint;
    std::vector<double> levels = levels_of(profile.joints, least_step * course, level_of_joint);
    levels.back() = std::max(levels.back(), crown_level);
    if (levels.back() - levels.front() < 0.3 * course)
        throw InputError("rise", "the arch is lower than a third of a course",
                         "give a higher rise or lower blocks");
    std::vector<int> bed_of_level{0};
    profile.beds.push_back(levels[0]);
    for (std::size_t k = 1; k < levels.size(); ++k) {
        add_courses(profile.beds, levels[k], course);
        bed_of_level.push_back(profile.courses());
    }
    profile.crown_bed = profile.courses();
    for (std::size_t i = 0; i < profile.joints.size(); ++i) {
        raise(profile.joints[i], levels[level_of_joint[i]]);
        profile.bed_of_joint.push_back(bed_of_level[level_of_joint[i]]);
    }
    check_convex(profile, curve.voussoirs);
    return profile;
}

}  // namespace voussoir::importers::patterns
