#include <cmath>

#include "importers/patterns/circular_arc.h"
#include "importers/patterns/parameter_checks.h"
#include "importers/patterns/vaults.h"

namespace voussoir::importers::patterns
{
namespace
{

void check(const BarrelVault& vault)
{
    std::vector<Fault> faults;
    check_arc(vault.span, vault.rise, faults);
    check_positive("thickness", vault.thickness, faults);
    check_positive("length", vault.length, faults);
    check_positive("support", vault.support, faults);
    check_number("courses", vault.courses, 2, faults);
    check_number("stones", vault.stones, 1, faults);
    if (faults.empty()) check_stones("stones", (vault.courses + 2.0) * (vault.stones + 1.0), faults);
    if (!faults.empty()) throw InputError(faults);
}

/// All edges of a bed from the front to the back. @param angle from the crown, positive to the right [rad]
BedLine bed(StoneGrid& grid, const BarrelVault& vault, double angle, int steps)
{
    const CircularArc arc = arc_over(vault.span, vault.rise);
    const auto point = [&](double radius, int i) {
        return grid.corner({radius * std::sin(angle), vault.length * (i / static_cast<double>(steps) - 0.5),
                            arc.centre + radius * std::cos(angle)});
    };
    BedLine line;
    for (int i = 0; i <= steps; ++i) {
        const int inner = point(arc.radius, i);
        line.push_back({inner, point(arc.radius + vault.thickness, i)});
    }
    return line;
}

/// The edges of bed lines at which the stones of a course begin and end.
std::vector<int> heads_of_course(const BarrelVault& vault, int course)
{
    std::vector<int> heads;
    const int steps = vault.bonded ? 2 : 1, all = steps * vault.stones;
    for (int i = vault.bonded && course % 2 == 1 ? 1 : 0; i <= all; i += steps) heads.push_back(i);
    if (heads.front() != 0) heads.insert(heads.begin(), 0);
    if (heads.back() != all) heads.push_back(all);
    return heads;
}

}  // namespace

StoneGrid barrel_vault(const BarrelVault& vault)
{
    check(vault);
    StoneGrid grid;
    const int steps = (vault.bonded ? 2 : 1) * vault.stones;
    const double springing = arc_over(vault.span, vault.rise).springing;
    std::vector<BedLine> beds(1);  // the feet of the left supports first, those of the right ones last
    for (int i = 0; i <= vault.courses; ++i)
        beds.push_back(bed(grid, vault, springing * (2.0 * i / vault.courses - 1), steps));
    beds.emplace_back();
    for (const ThroughEdge& edge : beds[1]) beds.front().push_back(grid.foot(edge, -vault.support));
    for (const ThroughEdge& edge : beds[vault.courses + 1]) beds.back().push_back(grid.foot(edge, -vault.support));
    for (int i = 0; i <= vault.courses + 1; ++i) {
        const std::vector<int> heads = heads_of_course(vault, i);
        const std::string course = i == 0                   ? "support_left_"
                                   : i == vault.courses + 1 ? "support_right_"
                                                            : "vault_c" + numbered(i, vault.courses) + "_b";
        for (std::size_t j = 0; j + 1 < heads.size(); ++j) {
            const int stone = grid.add_stone(course + numbered(static_cast<int>(j) + 1, vault.stones + 1));
            const auto piece = [&](const BedLine& line) {
                return BedLine(line.begin() + heads[j], line.begin() + heads[j + 1] + 1);
            };
            grid.add_faces(stone, piece(beds[i]), piece(beds[i + 1]));
        }
    }
    return grid;
}

}  // namespace voussoir::importers::patterns
