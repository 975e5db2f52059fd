// What is wrong between two stones, in words.
#include <fmt/format.h>

#include "importers/assembly/assembly_phrases.h"

namespace voussoir::importers::assembly
{
namespace
{

constexpr double mortar_modulus = 1e9;  // Pa, of the example: a lime mortar

template <typename Pairs>
std::vector<int> stones_of(const Pairs& pairs)
{
    std::vector<int> stones;
    for (const auto& pair : pairs) {
        stones.push_back(pair.a);
        stones.push_back(pair.b);
    }
    std::sort(stones.begin(), stones.end());
    stones.erase(std::unique(stones.begin(), stones.end()), stones.end());
    return stones;
}

/// "a and b, c and d and 3 more pairs".
template <typename Pairs>
std::string pairs_words(const Assembly& assembly, const Pairs& pairs)
{
    constexpr std::size_t given = 2;
    std::string words;
    for (std::size_t i = 0; i < std::min(pairs.size(), given); ++i)
        words += (i == 0 ? "" : "; ") + pair_words(assembly, pairs[i].a, pairs[i].b);
    if (pairs.size() > given) words += fmt::format("; and {} more", plural(pairs.size() - given, "pair"));
    return words;
}

}  // namespace

void tell_overlaps(const Assembly& assembly, std::vector<AssemblyFinding>& findings)
{
    if (assembly.overlaps.empty()) return;
    const auto deepest =
        std::max_element(assembly.overlaps.begin(), assembly.overlaps.end(),
                         [](const StoneOverlap& x, const StoneOverlap& y) { return x.depth < y.depth; });
    const auto largest =
        std::max_element(assembly.overlaps.begin(), assembly.overlaps.end(),
                         [](const StoneOverlap& x, const StoneOverlap& y) { return x.volume < y.volume; });
    AssemblyFinding finding{"overlaps", {}, {}, stones_of(assembly.overlaps)};
    finding.what = fmt::format("{} of stones {}: {}; the largest shared volume is {:.3g} m3",
                               plural(assembly.overlaps.size(), "pair"),
                               verb(assembly.overlaps.size(), "overlaps", "overlap"),
                               pairs_words(assembly, assembly.overlaps), largest->volume);
    if (deepest->depth > 0)
        finding.what += fmt::format(", the deepest overlap {} ({})", length_words(deepest->depth),
                                    pair_words(assembly, deepest->a, deepest->b));
    finding.advice = "stones may touch but not overlap: ";
    finding.advice += deepest->depth > 0 ? fmt::format(
                                               "in the CAD file move or trim one stone of each pair by the depth "
                                               "of its overlap (at most {}; or {} off each of the two faces)",
                                               length_words(deepest->depth), length_words(0.5 * deepest->depth))
                                         : "in the CAD file subtract one stone of each pair from the other";
    if (deepest->depth > 0 && deepest->depth <= assembly_tolerance::contact * assembly.typical_size) {
        finding.harmless = true;
        finding.what += "; less than the contact tolerance";
    }
    findings.push_back(std::move(finding));
}

void tell_gaps(const Assembly& assembly, const AssemblyOrigin& origin, std::vector<AssemblyFinding>& findings)
{
    for (const GapGroup& group : assembly.gap_groups) {
        std::vector<StoneGap> gaps;
        double area = 0, mean = 0;
        for (const int gap : group.gaps) {
            gaps.push_back(assembly.gaps[gap]);
            area += gaps.back().area;
            mean += gaps.back().area * gaps.back().width;
        }
        mean /= area;
        const std::string widths = group.widest > 1.005 * group.narrowest
                                       ? length_words(group.narrowest) + " to " + length_words(group.widest)
                                       : length_words(group.widest);
        AssemblyFinding finding{"gaps", {}, {}, stones_of(gaps)};
        finding.what =
            fmt::format("{} {} {} apart, over {:.3g} m2 in all: {}", plural(gaps.size(), "pair"),
                        gaps.size() == 1 ? "stands" : "stand", widths, area, pairs_words(assembly, gaps));
        finding.advice = fmt::format(
            "a joint drawn as a gap transfers no force. If it is a mortar joint, close it: {} moves both faces to "
            "the middle; a mortar of modulus E is then represented by contact_stiffness: E / {} of its joint "
            "(with E = 1 GPa: {:.3g} GPa/m). If it is dry, move the stones together in the CAD file",
            close_joints_words(group.widest, origin), length_words(mean), mortar_modulus / mean / 1e9);
        findings.push_back(std::move(finding));
    }
}

void tell_poor_contacts(const Assembly& assembly, const AssemblyOrigin& origin,
                        std::vector<AssemblyFinding>& findings)
{
    std::vector<StoneContact> tilted, small;
    double opening = 0;
    for (const StoneContact& contact : assembly.contacts) {
        if (begins_apart(assembly, origin, contact.a) || begins_apart(assembly, origin, contact.b)) continue;
        if (contact.touch == Touch::tilted) {
            tilted.push_back(contact);
            opening = std::max(opening, contact.largest_gap);
        } else if (contact.touch != Touch::face) {
            small.push_back(contact);
        }
    }
    if (!tilted.empty())
        findings.push_back(
            {"tilted",
             fmt::format(
                 "{} {} with an edge only, because the faces are inclined to each other and open up to {}: {}",
                 plural(tilted.size(), "pair"), verb(tilted.size(), "touches", "touch"), length_words(opening),
                 pairs_words(assembly, tilted)),
             "the joint will rock on that edge: in the CAD file give both stones the same joint plane",
             stones_of(tilted)});
    if (!small.empty())
        findings.push_back(
            {"small contact",
             fmt::format("{} {} with a corner, two crossing edges or less than {:g} % of a face only: {}",
                         plural(small.size(), "pair"), verb(small.size(), "touches", "touch"),
                         100 * assembly_tolerance::sliver_share, pairs_words(assembly, small)),
             "such contacts open and close repeatedly and need more iterations: separate the stones there, or "
             "give them a common face",
             stones_of(small), true});
}

}  // namespace voussoir::importers::assembly
