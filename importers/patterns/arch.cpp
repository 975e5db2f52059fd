#include "importers/patterns/arch.h"

#include <cmath>

#include "importers/patterns/bond.h"
#include "importers/patterns/parameter_checks.h"
#include "importers/patterns/stone_grid.h"

namespace voussoir::importers::patterns
{
namespace
{

void check(const Arch& arch)
{
    std::vector<Fault> faults;
    check_curve(arch.curve, faults);
    check_positive("width", arch.width, faults);
    check_positive("springing_height", arch.springing_height, faults);
    check_number("stones_across", arch.stones_across, 1, faults);
    if (faults.empty())
        check_stones("voussoirs", (arch.curve.voussoirs + 1.0) * (arch.stones_across + 1.0), faults);
    if (arch.curve.springing_thickness < 0)
        faults.push_back({"springing_thickness", std::to_string(arch.curve.springing_thickness), "must be > 0 m"});
    check_stone_imperfection(arch.imperfection, faults);
    if (!faults.empty()) throw InputError(faults);
}

/// Below an end joint. @param side -1 on the left, 1 on the right
PatternStone springing(const Arch& arch, const ArchJoint& joint, int side)
{
    const double thickness = (joint.extrados - joint.intrados).norm();
    const double back = to_nanometre(joint.extrados.x() + side * thickness / 2);
    const double foot = to_nanometre(-arch.springing_height);
    const std::string name = arch.name + (side < 0 ? "springing_left" : "springing_right");
    const std::vector<Point> outline{
        joint.intrados, joint.extrados, {back, joint.extrados.y()}, {back, foot}, {joint.intrados.x(), foot}};
    return {name, foundation_group, {prism_along_y(outline, -arch.width / 2, arch.width / 2, name)}};
}

}  // namespace

std::string voussoir_name(int number, int count)
{
    if (count % 2 == 1 && 2 * number == count + 1) return "keystone";
    const std::string digits = std::to_string(number);
    const std::size_t width = std::max<std::size_t>(2, std::to_string(count).size());
    return "voussoir_" + std::string(width - digits.size(), '0') + digits;
}

std::vector<std::vector<Point>> voussoir_outlines(const ArchCurve& curve, const std::vector<ArchJoint>& joints,
                                                  int i)
{
    const ArchJoint &left = joints[i], &right = joints[i + 1];
    if (curve.shape != ArchShape::pointed || left.intrados.x() >= 0 || right.intrados.x() <= 0)
        return {{left.intrados, left.extrados, right.extrados, right.intrados}};
    const ArchJoint apex = apex_of(curve);
    return {{left.intrados, left.extrados, apex.extrados, apex.intrados},
            {apex.intrados, apex.extrados, right.extrados, right.intrados}};
}

std::vector<ConvexPolyhedron> voussoir_parts(const std::vector<std::vector<Point>>& outlines, double front,
                                             double back, const std::string& name)
{
    std::vector<ConvexPolyhedron> parts;
    for (const std::vector<Point>& outline : outlines) {
        parts.push_back(prism_along_y(outline, front, back, name));
        if (outlines.size() > 1) glue(parts.back(), {0, 0, 0}, {1, 0, 0});
    }
    return parts;
}

Pattern arch(const Arch& arch)
{
    check(arch);
    const std::vector<ArchJoint> joints = joints_of(arch.curve);
    Pattern pattern;
    pattern.stones.push_back(springing(arch, joints.front(), -1));
    const int count = arch.curve.voussoirs;
    for (int i = 0; i < count; ++i) {
        const std::string name = arch.name + voussoir_name(i + 1, count);
        const std::vector<std::vector<Point>> outlines = voussoir_outlines(arch.curve, joints, i);
        const std::vector<double> across =
            joints_of_course(-arch.width / 2, arch.width / 2, arch.width / arch.stones_across, i);
        for (std::size_t b = 0; b + 1 < across.size(); ++b) {
            const std::string own = arch.stones_across == 1
                                        ? name
                                        : name + "_b" + numbered(static_cast<int>(b) + 1, arch.stones_across);
            pattern.stones.push_back({own, "voussoirs", voussoir_parts(outlines, across[b], across[b + 1], own),
                                      outlines.size() == 1 ? Play::across : Play::none});
        }
    }
    pattern.stones.push_back(springing(arch, joints.back(), 1));
    disturb(pattern, arch.imperfection);
    return pattern;
}

}  // namespace voussoir::importers::patterns
