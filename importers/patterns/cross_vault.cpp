#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "importers/patterns/circular_arc.h"
#include "importers/patterns/parameter_checks.h"
#include "importers/patterns/vault_ribs.h"
#include "importers/patterns/vaults.h"

namespace voussoir::importers::patterns
{
namespace
{

void check(const CrossVault& vault)
{
    std::vector<Fault> faults;
    check_arc(vault.span, vault.rise, faults);
    check_positive("thickness", vault.thickness, faults);
    check_positive("margin", vault.margin, faults);
    check_positive("support", vault.support, faults);
    check_number("courses", vault.courses, 2, faults);
    check_number("stones", vault.stones, 1, faults);
    check_ribs(vault, faults);
    if (faults.empty()) check_stones("stones", 8.0 * vault.courses * (vault.stones + 1.0), faults);
    if (!faults.empty()) throw InputError(faults);
}

/// Half a web: along the one axis from the groin to the side of the bay, across it from the crown to the
/// springing. Its bed lines are numbered from the crown, its head joints from the side of the bay in steps of half
/// a stone.
class HalfWeb
{
 public:
    /// @param right, back signs of x and y in its quadrant; @param along 0 or 1: its stones lie along x or y
    HalfWeb(StoneGrid& grid, const CrossVault& vault, Eigen::Vector2d quadrant, int along)
        : grid_(grid), vault_(vault), quadrant_(std::move(quadrant)), along_(along)
    {
        const double outermost = (arc_.radius + vault.thickness) * std::sin(arc_.springing);
        side_ = outermost + vault.margin;
        step_ = side_ / (2 * vault.stones);
        for (int i = 0; i <= vault.courses; ++i) lines_.push_back(line(arc_.springing * i / vault.courses));
    }

    /// From the groin to the side of the bay.
    const BedLine& bed(int i) const { return lines_[i]; }
    /// Numbers of the head joints of the course between bed lines i and i + 1, the one nearest the groin first and
    /// 0 last. Courses on the two sides of the crown are a half stone off too.
    std::vector<int> heads(int i) const
    {
        const bool other_side = quadrant_[1 - along_] < 0;
        const int odd = (i + (other_side ? 1 : 0)) % 2;
        std::vector<int> heads;
        for (int m = static_cast<int>(lines_[i + 1].size()) - 2; m > 0; --m)
            if (m % 2 == odd) heads.push_back(m);
        heads.push_back(0);
        return heads;
    }
    /// The edges of a line from head joint to head joint; from the groin if `from` is -1.
    BedLine piece(const BedLine& line, int from, int to) const
    {
        return {from < 0 ? line.begin() : line.end() - 1 - from, line.end() - to};
    }

 private:
    /// From the groin, then the head joints that are at least a quarter of a stone from it.
    BedLine line(double angle)
    {
        const double groin_outside = (arc_.radius + vault_.thickness) * std::sin(angle);
        BedLine edges{edge(angle, {})};
        int last = 0;
        while (side_ - (last + 1) * step_ >= groin_outside + step_ / 2) ++last;
        for (int m = last; m >= 0; --m) edges.push_back(edge(angle, side_ - m * step_));
        return edges;
    }
    /// At a place along the web, or at the groin.
    ThroughEdge edge(double angle, std::optional<double> place)
    {
        const int inner = point(arc_.radius, angle, place);
        return {inner, point(arc_.radius + vault_.thickness, angle, place)};
    }
    int point(double radius, double angle, std::optional<double> place)
    {
        const double across = radius * std::sin(angle);
        Eigen::Vector3d x;
        x[along_] = quadrant_[along_] * place.value_or(across);
        x[1 - along_] = quadrant_[1 - along_] * across;
        x.z() = arc_.centre + radius * std::cos(angle);
        return grid_.corner(x);
    }

    StoneGrid& grid_;
    const CrossVault& vault_;
    Eigen::Vector2d quadrant_;
    int along_;
    CircularArc arc_ = arc_over(vault_.span, vault_.rise);
    double side_ = 0, step_ = 0;  // m: from the middle to the side of the bay; half a stone
    std::vector<BedLine> lines_;
};

/// The stone of a course at the groin: a leg in each half web, to the first head joint.
void add_groin_stone(StoneGrid& grid, const std::array<HalfWeb, 2>& webs, int course, const std::string& name)
{
    const int stone = grid.add_stone(name);
    for (const HalfWeb& web : webs) {
        const int head = web.heads(course).front();
        grid.add_faces(stone, web.piece(web.bed(course + 1), -1, head), web.piece(web.bed(course), -1, head),
                       {false, true});
    }
}

void add_web_stones(StoneGrid& grid, const HalfWeb& web, int course, const std::string& name)
{
    const std::vector<int> heads = web.heads(course);
    for (std::size_t j = 0; j + 1 < heads.size(); ++j) {
        const int stone = grid.add_stone(name + "_b" + numbered(static_cast<int>(j) + 1, 0));
        grid.add_faces(stone, web.piece(web.bed(course + 1), heads[j], heads[j + 1]),
                       web.piece(web.bed(course), heads[j], heads[j + 1]));
    }
}

void add_support(StoneGrid& grid, const CrossVault& vault, const std::array<HalfWeb, 2>& webs,
                 const std::string& name)
{
    const int stone = grid.add_stone(name);
    for (const HalfWeb& web : webs) {
        BedLine feet;
        for (const ThroughEdge& edge : web.bed(vault.courses)) feet.push_back(grid.foot(edge, -vault.support));
        grid.add_faces(stone, feet, web.bed(vault.courses), {false, true});
    }
}

}  // namespace

StoneGrid cross_vault(const CrossVault& vault)
{
    check(vault);
    StoneGrid grid;
    const std::array<std::pair<const char*, Eigen::Vector2d>, 4> quadrants{
        {{"ne", {1, 1}}, {"nw", {-1, 1}}, {"sw", {-1, -1}}, {"se", {1, -1}}}};
    for (const auto& [name, signs] : quadrants) {
        const std::array<HalfWeb, 2> webs{HalfWeb(grid, vault, signs, 0), HalfWeb(grid, vault, signs, 1)};
        add_support(grid, vault, webs, std::string("support_") + name);
        for (int i = vault.courses - 1; i >= 0; --i) {
            const std::string course = "_c" + numbered(vault.courses - i, vault.courses);
            add_groin_stone(grid, webs, i, std::string("groin_") + name + course);
            add_web_stones(grid, webs[0], i, std::string("web_") + name + "_x" + course);
            add_web_stones(grid, webs[1], i, std::string("web_") + name + "_y" + course);
        }
    }
    return grid;
}

}  // namespace voussoir::importers::patterns
