#include "importers/assembly/assembly_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "importers/assembly/assembly_phrases.h"

namespace voussoir::importers::assembly
{
namespace
{

struct NamedUnit {
    const char* name;
    double metres;
};

/// A unit in which the stones would be of a size that people move, if the file's own gives none.
void suspect_unit(const Assembly& assembly, const AssemblyOrigin& origin, std::vector<AssemblyFinding>& findings)
{
    constexpr double least_stone = 0.02, max_stone = 20, least_whole = 0.05, max_whole = 1500;  // m
    constexpr double likely_least = 0.04, likely_most = 4;                                      // m
    constexpr std::array<NamedUnit, 5> units{
        {{"mm", 1e-3}, {"cm", 1e-2}, {"in", 0.0254}, {"ft", 0.3048}, {"m", 1}}};
    const double size = assembly.typical_size, whole = assembly.extent.maxCoeff();
    if (size >= least_stone && size <= max_stone && whole >= least_whole && whole <= max_whole) return;
    AssemblyFinding finding{"unit",
                            fmt::format("the whole is {} long, a typical stone {}: is the unit right?",
                                        length_words(whole), length_words(size)),
                            "",
                            {}};
    std::string likely;
    for (const NamedUnit& unit : units) {
        if (origin.metres_per_unit == 0) break;
        const double factor = unit.metres / origin.metres_per_unit;
        if (factor * size < likely_least || factor * size > likely_most) continue;
        likely += fmt::format("{}with {}{} the whole is {} long and a typical stone {}",
                              likely.empty() ? "" : "; ", origin.from_case ? "unit: " : "--unit ", unit.name,
                              length_words(factor * whole), length_words(factor * size));
    }
    finding.advice = likely.empty() ? "give the unit of the file" : likely;
    findings.push_back(std::move(finding));
}

/// The narrowest gap of a stone, none if no stone is near.
const StoneGap* nearest_gap(const Assembly& assembly, int stone)
{
    const StoneGap* nearest = nullptr;
    for (const StoneGap& gap : assembly.gaps)
        if ((gap.a == stone || gap.b == stone) && (!nearest || gap.width < nearest->width)) nearest = &gap;
    return nearest;
}

void tell_floating(const Assembly& assembly, const AssemblyOrigin& origin, std::vector<AssemblyFinding>& findings)
{
    std::vector<int> near, alone;
    double widest = 0;
    for (const int stone : assembly.floating) {
        if (begins_apart(assembly, origin, stone)) continue;
        const StoneGap* gap = nearest_gap(assembly, stone);
        (gap ? near : alone).push_back(stone);
        if (gap) widest = std::max(widest, gap->widest);
    }
    if (!near.empty())
        findings.push_back({"floating",
                            fmt::format("{} {} no other but {} neighbours across a gap: {}",
                                        plural(near.size(), "stone"), verb(near.size(), "touches", "touch"),
                                        verb(near.size(), "has", "have"), names_of(assembly, near)),
                            fmt::format("close the gaps: {} is enough", close_joints_words(widest, origin)),
                            near});
    if (!alone.empty())
        findings.push_back({"floating",
                            fmt::format("{} {} no other and none is near: {}", plural(alone.size(), "stone"),
                                        verb(alone.size(), "touches", "touch"), names_of(assembly, alone)),
                            "in the CAD file move them to their neighbours, or delete them", alone});
}

void tell_unsupported(const Assembly& assembly, const AssemblyOrigin& origin,
                      std::vector<AssemblyFinding>& findings)
{
    std::vector<int> stones;
    std::set_difference(assembly.unsupported.begin(), assembly.unsupported.end(), assembly.floating.begin(),
                        assembly.floating.end(), std::back_inserter(stones));
    std::erase_if(stones, [&](int stone) { return begins_apart(assembly, origin, stone); });
    if (stones.empty()) return;
    const std::string ground = assembly.ground_given ? "foundation" : "stone at the lowest level";
    findings.push_back({"unsupported",
                        fmt::format("{} are connected, but no path of contacts leads from them to a {}: {}",
                                    plural(stones.size(), "stone"), ground, names_of(assembly, stones)),
                        origin.from_case
                            ? "they would fall together: close the gap to the stones that should support them, or "
                              "make the lowest of them foundations"
                            : "they would fall together: close the gap to the stones that should support them",
                        stones});
}

void tell_slivers(const Assembly& assembly, std::vector<AssemblyFinding>& findings)
{
    std::vector<int> thin, short_edged;
    double thinnest = 1, shortest = 1;
    for (const SliverStone& sliver : assembly.slivers) {
        (sliver.thin ? thin : short_edged).push_back(sliver.stone);
        if (sliver.thin)
            thinnest = std::min(thinnest, sliver.width / sliver.diameter);
        else
            shortest = std::min(shortest, sliver.shortest_edge / sliver.diameter);
    }
    if (!thin.empty())
        findings.push_back({"slivers",
                            fmt::format("{} {} thinner than 1:{:g} (down to 1:{:.0f}): {}",
                                        plural(thin.size(), "stone"), verb(thin.size(), "is", "are"),
                                        1 / assembly_tolerance::thin, 1 / thinnest, names_of(assembly, thin)),
                            "a sliver has very little stiffness and requires small time steps: in the CAD file "
                            "merge it with its neighbour, or omit it",
                            thin});
    if (!short_edged.empty())
        findings.push_back(
            {"short edges",
             fmt::format("{} {} an edge shorter than 1:{:g} of the stone (down to 1:{:.0f}): {}",
                         plural(short_edged.size(), "stone"), verb(short_edged.size(), "has", "have"),
                         1 / assembly_tolerance::short_edge, 1 / shortest, names_of(assembly, short_edged)),
             "in the CAD file merge the two corners", short_edged, true});
}

void tell_sizes(const Assembly& assembly, const AssemblyOrigin& origin, std::vector<AssemblyFinding>& findings)
{
    if (assembly.size_ratio > assembly_tolerance::size_ratio) {
        const AssemblyStone& large = assembly.stones[assembly.largest];
        const AssemblyStone& small = assembly.stones[assembly.smallest];
        findings.push_back(
            {"size ratio",
             fmt::format(
                 "the largest stone, {} ({:.3g} m3), has {:.0f} times the volume of the smallest, {} ({:.3g} "
                 "m3)",
                 large.name, large.volume, assembly.size_ratio, small.name, small.volume),
             origin.from_case ? "make the large one a foundation if it is the ground, or omit chips"
                              : "omit chips, or divide the large stone at its real joints",
             {assembly.largest, assembly.smallest}});
    }
    std::vector<int> many, approximated;
    double error = 0;
    for (int i = 0; i < static_cast<int>(assembly.stones.size()); ++i) {
        const AssemblyStone& stone = assembly.stones[i];
        if (static_cast<int>(stone.parts.size()) > assembly_tolerance::many_parts) many.push_back(i);
        if (stone.volume_error > 0) approximated.push_back(i);
        error = std::max(error, stone.volume_error);
    }
    if (!many.empty())
        findings.push_back({"many parts",
                            fmt::format("{} of more than {} convex parts: {}", plural(many.size(), "stone"),
                                        assembly_tolerance::many_parts, names_of(assembly, many)),
                            "each part is searched for contact: a simpler outline runs faster", many, true});
    if (!approximated.empty())
        findings.push_back(
            {"approximated",
             fmt::format("{} whose convex parts only approximate them, by up to {:.3g} % of the volume: {}",
                         plural(approximated.size(), "stone"), 100 * error, names_of(assembly, approximated)),
             "volume and moments are those of the original stone; contacts are those of the parts", approximated,
             true});
}

void tell_refused(const AssemblyOrigin& origin, std::vector<AssemblyFinding>& findings)
{
    if (origin.refused_stones == 0) return;
    findings.push_back(
        {"refused",
         fmt::format(
             "{} {} refused and not in the contact graph: stones that touch only these are reported as floating",
             plural(origin.refused_stones, "stone"), verb(origin.refused_stones, "is", "are")),
         "repair the refused stones first",
         {}});
}

}  // namespace

bool begins_apart(const Assembly& assembly, const AssemblyOrigin& origin, int stone)
{
    return origin.apart.count(assembly.stones[stone].name) > 0;
}

std::vector<AssemblyFinding> findings_in_words(const Assembly& assembly, const AssemblyOrigin& origin)
{
    std::vector<AssemblyFinding> findings;
    tell_refused(origin, findings);
    suspect_unit(assembly, origin, findings);
    tell_overlaps(assembly, findings);
    tell_floating(assembly, origin, findings);
    tell_unsupported(assembly, origin, findings);
    tell_gaps(assembly, origin, findings);
    tell_poor_contacts(assembly, origin, findings);
    tell_slivers(assembly, findings);
    tell_sizes(assembly, origin, findings);
    return findings;
}

}  // namespace voussoir::importers::assembly
