#include "importers/patterns/column.h"

#include <algorithm>
#include <cmath>

#include "importers/patterns/parameter_checks.h"

namespace voussoir::importers::patterns
{
namespace
{

std::string metres(double value)
{
    return std::to_string(value) + " m";
}

void check(const Column& column, std::vector<Fault>& faults)
{
    check_positive("height", column.height, faults);
    check_positive("diameter", column.diameter, faults);
    check_positive("top_diameter", column.top_diameter, faults);
    check_number("drums", column.drums, 1, faults);
    if (column.sides < 4 || column.sides > 64 || column.sides % 4 != 0)
        faults.push_back({"sides", std::to_string(column.sides), "must be 4, 8, 12, ..., 64"});
    if (!(column.entasis >= 0 && column.entasis < column.diameter / 4))
        faults.push_back(
            {"entasis", metres(column.entasis), "must be >= 0 m and less than a quarter of the diameter"});
    if (column.capital_height == 0) return;
    check_positive("capital.height", column.capital_height, faults);
    if (!(column.capital_width >= column.top_diameter))
        faults.push_back({"capital.width", metres(column.capital_width), "must be at least top_diameter"});
}

double diameter_at(const Column& column, double share)
{
    return column.diameter + (column.top_diameter - column.diameter) * share +
           4 * column.entasis * share * (1 - share);
}

/// The stones of a column from z = 0 up.
void add_column(Pattern& pattern, const Column& column, const Point& centre, const std::string& name)
{
    const auto add = [&](const std::string& own, const char* group, ConvexPolyhedron shape) {
        pattern.stones.push_back({name + own, group, {std::move(shape)}, Play::level});
    };
    for (int i = 0; i < column.drums; ++i) {
        const double from = static_cast<double>(i) / column.drums, to = (i + 1.0) / column.drums;
        const std::string own = "drum_" + std::to_string(i + 1);
        add(own, "drums",
            frustum(regular_outline(centre, diameter_at(column, from), column.sides),
                    to_nanometre(column.height * from),
                    regular_outline(centre, diameter_at(column, to), column.sides),
                    to_nanometre(column.height * to), name + own));
    }
    if (column.capital_height == 0) return;
    const double foot = column.height, bed = to_nanometre(foot + column.capital_height / 2);
    const double top = to_nanometre(foot + column.capital_height), half = column.capital_width / 2;
    add("echinus", "capital",
        frustum(regular_outline(centre, column.top_diameter, column.sides), foot,
                regular_outline(centre, column.capital_width, column.sides), bed, name + "echinus"));
    add("abacus", "capital",
        make_box({to_nanometre(centre.x() - half), to_nanometre(centre.y() - half), bed},
                 {to_nanometre(centre.x() + half), to_nanometre(centre.y() + half), top}));
}

void add_slab(Pattern& pattern, const std::string& name, double half_x, double half_y, double height)
{
    pattern.stones.push_back({name,
                              foundation_group,
                              {make_box({-to_nanometre(half_x), -to_nanometre(half_y), -height},
                                        {to_nanometre(half_x), to_nanometre(half_y), 0})}});
}

/// Beginning, joints and end of a course on the columns: at their axes, or over the middles between them.
std::vector<double> joints_over(const TempleFront& front, double half, bool at_axes)
{
    std::vector<double> joints{-half};
    for (int i = at_axes ? 1 : 0; i + 1 < front.columns; ++i)
        joints.push_back(to_nanometre((i - (front.columns - 1) / 2.0 + (at_axes ? 0 : 0.5)) * front.spacing));
    joints.push_back(half);
    return joints;
}

void add_course(Pattern& pattern, const std::string& name, const std::vector<double>& joints, double depth,
                double foot, double top)
{
    for (std::size_t i = 0; i + 1 < joints.size(); ++i)
        pattern.stones.push_back({name + "_" + std::to_string(i + 1),
                                  "entablature",
                                  {make_box({joints[i], -depth / 2, foot}, {joints[i + 1], depth / 2, top})},
                                  Play::level});
}

/// Upright stones under two slopes.
void add_pediment(Pattern& pattern, const TempleFront& front, const std::string& name, double half, double depth,
                  double foot)
{
    std::vector<double> joints = joints_over(front, half, true);
    const std::vector<double> others = joints_over(front, half, false);
    joints.insert(joints.end(), others.begin(), others.end());
    joints.push_back(0);
    std::sort(joints.begin(), joints.end());
    joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
    const auto back = [&](double x) {
        return to_nanometre(foot + front.pediment_edge +
                            (front.pediment - front.pediment_edge) * (1 - std::abs(x) / half));
    };
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const double a = joints[i], b = joints[i + 1];
        const std::string own = name + "pediment_" + std::to_string(i + 1);
        pattern.stones.push_back(
            {own,
             "pediment",
             {prism_along_y({{a, foot}, {b, foot}, {b, back(b)}, {a, back(a)}}, -depth / 2, depth / 2, own)},
             Play::across});
    }
}

void check(const TempleFront& front)
{
    std::vector<Fault> faults;
    check(front.column, faults);
    check_number("columns", front.columns, 1, faults);
    check_positive("spacing", front.spacing, faults);
    const double widest = std::max({front.column.diameter, front.column.top_diameter,
                                    front.column.capital_height > 0 ? front.column.capital_width : 0.0});
    if (faults.empty() && front.spacing <= widest + 1e-6)
        faults.push_back({"spacing", metres(front.spacing), "the columns must stand apart"});
    for (const auto& [name, value] : {std::pair{"architrave", front.architrave},
                                      {"frieze", front.frieze},
                                      {"pediment", front.pediment},
                                      {"depth", front.depth}})
        if (!(value >= 0 && std::isfinite(value))) faults.push_back({name, metres(value), "must be >= 0 m"});
    if (front.pediment > 0 && !(front.pediment_edge > 0 && front.pediment_edge <= front.pediment))
        faults.push_back({"pediment_edge", metres(front.pediment_edge), "must be > 0 m and at most pediment"});
    if (front.architrave == 0 && (front.frieze > 0 || front.pediment > 0))
        faults.push_back({"architrave", "none", "a frieze and a pediment need one"});
    if (!faults.empty()) throw InputError(faults);
}

}  // namespace

Pattern column(const Column& column, const std::string& name)
{
    std::vector<Fault> faults;
    check(column, faults);
    if (!faults.empty()) throw InputError(faults);
    Pattern pattern;
    add_slab(pattern, name + "slab", column.diameter, column.diameter, column.diameter / 2);
    add_column(pattern, column, {0, 0}, name);
    return pattern;
}

Pattern temple_front(const TempleFront& front, const std::string& name)
{
    check(front);
    const Column& column = front.column;
    const double head = column.capital_height > 0 ? column.capital_width : column.top_diameter;
    const double depth = to_nanometre(front.depth > 0 ? front.depth : 0.8 * head);
    const double row = (front.columns - 1) / 2.0 * front.spacing, half = to_nanometre(row + head / 2);
    Pattern pattern;
    add_slab(pattern, name + "stylobate", row + column.diameter, column.diameter, column.diameter / 2);
    for (int i = 0; i < front.columns; ++i)
        add_column(pattern, column, {i * front.spacing - row, 0}, name + "column_" + std::to_string(i + 1) + "_");
    double level = to_nanometre(column.height + column.capital_height);
    const auto add = [&](const char* own, double height, bool at_axes) {
        if (height == 0) return;
        const double top = to_nanometre(level + height);
        add_course(pattern, name + own, joints_over(front, half, at_axes), depth, level, top);
        level = top;
    };
    add("architrave", front.architrave, true);
    add("frieze", front.frieze, false);
    if (front.pediment > 0) add_pediment(pattern, front, name, half, depth, level);
    return pattern;
}

}  // namespace voussoir::importers::patterns
