#include "importers/patterns/tower.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "importers/patterns/parameter_checks.h"
#include "importers/patterns/ring.h"
#include "importers/patterns/stone_grid.h"

namespace voussoir::importers::patterns
{
namespace
{

std::string metres(double value)
{
    return std::to_string(value) + " m";
}

void check_storey(const Tower& tower, std::size_t number, std::vector<Fault>& faults)
{
    const Storey& storey = tower.storeys[number];
    const std::string key = "storeys[" + std::to_string(number) + "]";
    const std::size_t before = faults.size();
    check_positive(key + ".height", storey.height, faults);
    check_positive(key + ".thickness", storey.thickness, faults);
    if (!(storey.floor >= 0)) faults.push_back({key + ".floor", std::to_string(storey.floor), "must be >= 0 kg"});
    if (faults.size() > before) return;
    const Ring ring(tower.sides, tower.width, storey.thickness, tower.block.length);
    if (storey.thickness > 0.4 * tower.width || ring.side() < 2 * ring.corner() + 0.5 * tower.block.length)
        faults.push_back({key + ".thickness", metres(storey.thickness),
                          "must leave room for a stone between the corners, and for a shaft inside"});
    for (std::size_t i = 0; i < storey.openings.size(); ++i) {
        const TowerOpening& opening = storey.openings[i];
        const std::string own = key + ".openings[" + std::to_string(i) + "]";
        const double room = tower.sides == 0 ? ring.length() / 4 : ring.side() - 2 * ring.corner();
        if (!(opening.width > 0 && opening.height > 0 && opening.sill >= 0))
            faults.push_back({own, "no opening", "width and height must be > 0 m, sill >= 0 m"});
        else if (opening.width + 2 * tower.bearing > room + 1e-9)
            faults.push_back(
                {own + ".width", metres(opening.width),
                 "with its lintel it must fit between the corners: at most " + metres(room - 2 * tower.bearing)});
        else if (opening.sill + opening.height > storey.height + 1e-9)
            faults.push_back({own + ".height", metres(opening.height), "it ends above its storey"});
    }
}

void check(const Tower& tower)
{
    std::vector<Fault> faults;
    check_positive("width", tower.width, faults);
    check_positive("block", tower.block.length, faults);
    check_positive("block", tower.block.height, faults);
    check_positive("bearing", tower.bearing, faults);
    check_base({tower.base_height, tower.base_projection}, faults);
    check_stone_imperfection(tower.imperfection, faults);
    if (tower.storeys.empty()) faults.push_back({"storeys", "none", "give at least one {height, thickness}"});
    if (!faults.empty()) throw InputError(faults);
    double stones = 0;
    for (std::size_t i = 0; i < tower.storeys.size(); ++i) {
        check_storey(tower, i, faults);
        stones += 4 * tower.width / tower.block.length * tower.storeys[i].height / tower.block.height;
    }
    check_stones("block", stones, faults);
    if (!faults.empty()) throw InputError(faults);
}

/// A storey while it is built. Levels from its foot, m.
struct StoreyWork {
    const Tower& tower;
    const Storey& storey;
    std::string name, key;
    double foot = 0;  // m
    Ring ring;
    std::vector<double> beds;
    double top_of_lintel(const TowerOpening& opening) const
    {
        const double head = opening.sill + opening.height;
        return head + 1e-9 >= storey.height ? head : std::min(storey.height, head + tower.block.height);
    }
};

std::vector<double> beds_of(const StoreyWork& work)
{
    std::vector<double> levels{0, work.storey.height};
    for (const TowerOpening& opening : work.storey.openings)
        levels.insert(levels.end(), {opening.sill, opening.sill + opening.height, work.top_of_lintel(opening)});
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end(), [](double a, double b) { return b - a < 1e-9; }),
                 levels.end());
    std::vector<double> beds{0};
    for (std::size_t k = 1; k < levels.size(); ++k) {
        const double from = levels[k - 1], rise = levels[k] - from;
        if (rise < work.tower.block.height / 3)
            throw InputError(work.key + ".openings", "two beds at " + metres(from) + " and " + metres(levels[k]),
                             "sills, heads and lintels must be a third of a course apart, or level");
        const int count = std::max(1, static_cast<int>(std::lround(rise / work.tower.block.height)));
        for (int i = 1; i <= count; ++i) beds.push_back(from + rise * i / count);
    }
    return beds;
}

/// A piece of a course: a hole, a lintel, or between them. Places along the ring, m.
struct Piece {
    double from = 0, to = 0;
    int lintel = -1;  // the opening it bridges
    bool hole = false;
};

/// Openings and lintels in a course, ascending; all begin at > 0 or before the first side's middle.
std::vector<Piece> interruptions(const StoreyWork& work, double foot, double top)
{
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < work.storey.openings.size(); ++i) {
        const TowerOpening& opening = work.storey.openings[i];
        const double middle = work.ring.length() * opening.side / (work.tower.sides == 0 ? 4 : work.tower.sides);
        const double head = opening.sill + opening.height, half = opening.width / 2;
        if (foot >= opening.sill - 1e-9 && top <= head + 1e-9)
            pieces.push_back({middle - half, middle + half, -1, true});
        else if (foot >= head - 1e-9 && top <= work.top_of_lintel(opening) + 1e-9)
            pieces.push_back({middle - half - work.tower.bearing, middle + half + work.tower.bearing,
                              static_cast<int>(i), false});
    }
    std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.from < b.from; });
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
        if (pieces[i].to > pieces[i + 1].from + 1e-9)
            throw InputError(work.key + ".openings", "two openings or lintels in one place",
                             "give them different sides or levels");
    return pieces;
}

/// The stones of a course between interruptions; joints nearer to these than a quarter of a stone are left out.
std::vector<Piece> pieces_of(const StoreyWork& work, int course, double foot, double top)
{
    const double length = work.ring.length(), near = work.ring.stone() / 4;
    std::vector<double> joints = work.ring.joints(course);
    const std::vector<Piece> stops = interruptions(work, foot, top);
    std::vector<Piece> pieces;
    if (stops.empty()) {
        for (std::size_t i = 0; i < joints.size(); ++i)
            pieces.push_back({joints[i], i + 1 < joints.size() ? joints[i + 1] : joints[0] + length});
        return pieces;
    }
    for (std::size_t k = 0; k < stops.size(); ++k) {
        pieces.push_back(stops[k]);
        double from = stops[k].to;
        const double to = k + 1 < stops.size() ? stops[k + 1].from : stops[0].from + length;
        for (int turn = -1; turn <= 1; ++turn)
            for (const double joint : joints) {
                const double at = joint + turn * length;
                if (at <= stops[k].to + near || at >= to - near) continue;
                pieces.push_back({from, at});
                from = at;
            }
        if (to - from > 1e-9) pieces.push_back({from, to});
    }
    return pieces;
}

void add_stone(Pattern& pattern, const StoreyWork& work, const Piece& piece, const std::string& name, double foot,
               double top)
{
    // Places before the beginning of the ring are those before its end.
    const double turn = piece.from < 0 ? work.ring.length() : 0;
    const std::vector<std::vector<Point>> outlines = work.ring.parts(piece.from + turn, piece.to + turn);
    PatternStone stone{name, work.name, {}, outlines.size() == 1 ? Play::level : Play::none};
    for (std::size_t p = 0; p < outlines.size(); ++p) {
        stone.parts.push_back(prism_up(outlines[p], foot, top, name));
        const auto glue_at = [&](const Point& a, const Point& b) {
            glue(stone.parts.back(), {a.x(), a.y(), foot}, {b.y() - a.y(), a.x() - b.x(), 0});
        };
        if (p > 0) glue_at(outlines[p][0], outlines[p][3]);
        if (p + 1 < outlines.size()) glue_at(outlines[p][1], outlines[p][2]);
    }
    pattern.stones.push_back(std::move(stone));
}

/// @param first number of the storey's first course in the tower @returns that of the next storey's
int add_storey(Pattern& pattern, const StoreyWork& work, int first)
{
    const int courses = static_cast<int>(work.beds.size()) - 1;
    for (int c = 0; c < courses; ++c) {
        int number = 0;
        const double foot = to_nanometre(work.foot + work.beds[c]),
                     top = to_nanometre(work.foot + work.beds[c + 1]);
        const std::size_t before = pattern.stones.size();
        for (const Piece& piece : pieces_of(work, first + c, work.beds[c], work.beds[c + 1])) {
            if (piece.hole) continue;
            const std::string name =
                piece.lintel >= 0
                    ? work.tower.name + work.name + "_lintel_" + std::to_string(piece.lintel + 1)
                    : work.tower.name + work.name + "_c" + numbered(c + 1, 99) + "_b" + numbered(++number, 99);
            add_stone(pattern, work, piece, name, foot, top);
        }
        if (c + 1 < courses || work.storey.floor == 0) continue;
        const double each = work.storey.floor / static_cast<double>(pattern.stones.size() - before);
        for (std::size_t s = before; s < pattern.stones.size(); ++s) {
            Eigen::AlignedBox3d box;
            for (const ConvexPolyhedron& part : pattern.stones[s].parts)
                for (const Eigen::Vector3d& x : part.vertices) box.extend(x);
            pattern.masses.push_back({pattern.stones[s].name, each, {box.center().x(), box.center().y(), top}});
        }
    }
    return first + courses;
}

}  // namespace

Pattern tower(const Tower& tower)
{
    check(tower);
    Pattern pattern;
    const Ring ring(tower.sides, tower.width, tower.storeys[0].thickness, tower.block.length);
    if (tower.base_height > 0)
        pattern.stones.push_back(
            {tower.name + "base",
             foundation_group,
             {prism_up(ring.slab(tower.base_projection), -tower.base_height, 0, tower.name + "base")}});
    double foot = 0;
    int course = 0;
    for (std::size_t i = 0; i < tower.storeys.size(); ++i) {
        const Storey& storey = tower.storeys[i];
        StoreyWork work{tower,
                        storey,
                        storey.name.empty() ? "storey_" + std::to_string(i + 1) : storey.name,
                        "storeys[" + std::to_string(i) + "]",
                        foot,
                        Ring(tower.sides, tower.width, storey.thickness, tower.block.length),
                        {}};
        work.beds = beds_of(work);
        course = add_storey(pattern, work, course);
        foot = to_nanometre(foot + storey.height);
    }
    disturb(pattern, tower.imperfection);
    return pattern;
}

}  // namespace voussoir::importers::patterns
