#include "app/reader/drawn_fit.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "app/reader/local_origin.h"
#include "libdda/analysis/drawn_misfit.h"
#include "libdda/analysis/overlaps.h"

namespace voussoir::app::reader
{
namespace
{

/// A stone of a mesh that overlaps another by more than this share of its volume is a mistake, unless the
/// fit_tolerance covers the depth.
constexpr double max_overlap = 0.01;
constexpr double inside = 0.5;  // of its volume: a stone that shares so much was drawn into another
constexpr std::size_t worst_told = 5, most_told = 20;

using Pair = std::pair<int, int>;

std::string millimetres(double length)
{
    return fmt::format("{:.3g} mm", 1e3 * length);
}

std::string names_of(const Model& model, int block_a, int block_b)
{
    return model.blocks[block_a].name + " and " + model.blocks[block_b].name;
}

/// "0.84 mm, as the stones overlap by up to 0.83 mm (a and b) and gape by up to 0.2 mm (c and d)".
std::string reason_of(const Model& model, const DrawnMisfit& misfit)
{
    std::string reason;
    for (const Misfit* each : {&misfit.overlap, &misfit.gap}) {
        if (each->depth == 0) continue;
        reason += fmt::format("{}{} by up to {} ({})", reason.empty() ? "as joints " : " and ",
                              each == &misfit.gap ? "gape" : "overlap", millimetres(each->depth),
                              names_of(model, each->block_a, each->block_b));
    }
    return millimetres(misfit.tolerance()) + ", " + reason;
}

/// What the joints of meshes need, and the rounding of coordinates far from their origin.
void take_default_fit(YamlCursor& top, bool has_meshes, Model& model)
{
    std::string reason = "0, the joints fit";
    if (has_meshes) {
        const DrawnMisfit misfit = drawn_misfit(model);
        model.fit_tolerance = misfit.tolerance();
        if (model.fit_tolerance > 0) reason = reason_of(model, misfit);
    }
    if (const double rounding = rounded_misfit(model); rounding > model.fit_tolerance) {
        model.fit_tolerance = rounding;
        reason = millimetres(rounding) + ", as coordinates so far from their origin are rounded";
    }
    if (has_meshes || model.fit_tolerance > 0) top.took_default("fit_tolerance", reason);
}

/// Depth of all pairs of stones that overlap [m], whatever the fit_tolerance.
std::map<Pair, double> depths_as_drawn(Model model)
{
    model.fit_tolerance = 0;
    return OverlapWatch(model).drawn;
}

/// Overlaps of stones of meshes, whose volumes are known. Of a case that has faults already no depth is.
class MeshOverlaps
{
 public:
    MeshOverlaps(const Model& model, bool sound, Findings& findings)
        : model_(model), findings_(findings), depths_(sound ? depths_as_drawn(model) : std::map<Pair, double>())
    {
        for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) blocks_[model.blocks[b].name] = b;
    }
    void judge() const
    {
        std::vector<importers::helper::Overlap> refused;
        int small = 0;
        double most = 0;
        for (const importers::helper::Overlap& overlap : findings_.geometry.overlaps) {
            if (overlap.fraction > max_overlap && !is_covered(overlap)) {
                refused.push_back(overlap);
                continue;
            }
            ++small;
            most = std::max(most, overlap.fraction);
        }
        refuse(std::move(refused));
        if (small > 0)
            findings_.warnings.push_back(fmt::format(
                "{}: {} overlap, by at most {:.2g} % of the smaller one: {}; voussoir check lists them",
                findings_.mesh_place, small == 1 ? "1 pair of stones" : fmt::format("{} pairs of stones", small),
                100 * most, consequence()));
    }

 private:
    /// Depth of an overlap [m]; nothing when it is not known.
    std::optional<double> depth_of(const importers::helper::Overlap& overlap) const
    {
        const auto a = blocks_.find(overlap.stone_a), b = blocks_.find(overlap.stone_b);
        if (a == blocks_.end() || b == blocks_.end()) return std::nullopt;
        const auto depth = depths_.find(std::minmax(a->second, b->second));
        if (depth == depths_.end()) return std::nullopt;
        return depth->second;
    }
    bool is_covered(const importers::helper::Overlap& overlap) const
    {
        const std::optional<double> depth = depth_of(overlap);
        return depth && *depth <= model_.fit_tolerance;
    }
    /// The worst one by one, the rest in one line.
    void refuse(std::vector<importers::helper::Overlap> overlaps) const
    {
        std::stable_sort(overlaps.begin(), overlaps.end(),
                         [](const auto& a, const auto& b) { return a.fraction > b.fraction; });
        for (std::size_t i = 0; i < std::min(worst_told, overlaps.size()); ++i)
            findings_.faults.push_back(
                {findings_.mesh_place + ": " + overlaps[i].stone_a + " and " + overlaps[i].stone_b,
                 fmt::format("overlap by {:.3g} m3, {:.2g} % of the smaller one", overlaps[i].volume,
                             100 * overlaps[i].fraction),
                 cure_of(overlaps[i])});
        if (overlaps.size() > worst_told)
            findings_.faults.push_back(
                {findings_.mesh_place,
                 fmt::format("{} more pairs of stones overlap, by up to {:.2g} % of the smaller one",
                             overlaps.size() - worst_told, 100 * overlaps[worst_told].fraction),
                 "voussoir check --json lists them"});
    }
    std::string smaller_of(const importers::helper::Overlap& overlap) const
    {
        const auto a = blocks_.find(overlap.stone_a), b = blocks_.find(overlap.stone_b);
        if (a == blocks_.end() || b == blocks_.end()) return overlap.stone_b;
        const bool first = model_.blocks[a->second].moments.volume < model_.blocks[b->second].moments.volume;
        return first ? overlap.stone_a : overlap.stone_b;
    }
    std::string cure_of(const importers::helper::Overlap& overlap) const
    {
        if (overlap.fraction > inside)
            return fmt::format("the smaller one lies in the other: leave it out (skip: \"{}\")",
                               smaller_of(overlap));
        const std::optional<double> depth = depth_of(overlap);
        if (!depth) return "stones may touch but not overlap by more than 1 %: trim or move one of them";
        // Rounded up, so that it covers the depth.
        return fmt::format(
            "if this is the error of the survey, allow for it (fit_tolerance: {:.0f} mm); otherwise trim or move "
            "one "
            "of them by {}",
            std::ceil(1e3 * *depth), millimetres(*depth));
    }
    /// What becomes of the overlaps that are accepted.
    std::string consequence() const
    {
        double beyond = 0;
        for (const auto& [pair, depth] : depths_) beyond = std::max(beyond, depth - model_.fit_tolerance);
        if (beyond <= 0)
            return fmt::format("within the fit_tolerance of {} they are free of stress",
                               millimetres(model_.fit_tolerance));
        return fmt::format("what is deeper than the fit_tolerance of {}, up to {}, presses the stones apart",
                           millimetres(model_.fit_tolerance), millimetres(beyond));
    }

    const Model& model_;
    Findings& findings_;
    std::map<Pair, double> depths_;
    std::map<std::string, int> blocks_;
};

/// As a run judges them before its first step.
void refuse_deep_overlaps(const Model& model, Findings& findings)
{
    std::size_t told = 0;
    for (const DrawnOverlap& overlap : drawn_overlaps(OverlapWatch(model))) {
        if (overlap.share <= deepest_share || told++ >= most_told) continue;
        findings.faults.push_back(
            {findings.file + ": " + names_of(model, overlap.block_a, overlap.block_b),
             fmt::format("overlap by {} more than the fit_tolerance of {}, {:.2g} % of the thinner one's width",
                         millimetres(overlap.depth), millimetres(model.fit_tolerance), 100 * overlap.share),
             fmt::format("trim or move one of them by {}", millimetres(overlap.depth))});
    }
    if (told > most_told)
        findings.faults.push_back({findings.file, fmt::format("{} more overlaps", told - most_told),
                                   "voussoir check -o DIR draws the deepest"});
}

}  // namespace

std::optional<double> read_fit_tolerance(YamlCursor& top)
{
    return top.find_quantity("fit_tolerance", words::dimension::length, words::Range::non_negative());
}

void settle_fit(YamlCursor& top, const std::optional<double>& given, Case& result, Findings& findings)
{
    Model& model = result.model;
    const bool sound = findings.faults.empty() && !model.blocks.empty();
    if (given)
        model.fit_tolerance = *given;
    else if (sound)
        take_default_fit(top, !result.mesh_files.empty(), model);
    MeshOverlaps(model, sound, findings).judge();
    if (sound) refuse_deep_overlaps(model, findings);
}

void refuse_rounded_stresses(const Case& the_case, Findings& findings)
{
    constexpr double rounded_share = 1e-5;  // of the weight: a run that asks for less finds no equilibrium
    const Model& model = the_case.model;
    if (!findings.faults.empty() || !is_deformable(model.kinematics) || the_case.stages.empty()) return;
    const double gravity = the_case.stages.front().gravity.norm();
    for (const Block& block : model.blocks) {
        const BlockMaterial& stone = model.materials[static_cast<std::size_t>(block.material)];
        const double weight = stone.density * gravity * std::cbrt(block.moments.volume);  // Pa, on its own base
        const double rounding = std::numeric_limits<double>::epsilon() * stone.young;     // Pa
        if (!(weight > 0) || !(rounding > rounded_share * weight)) continue;
        findings.faults.push_back(
            {findings.file + ": " + block.name,
             fmt::format(
                 "its weight presses with {:.2g} Pa, and with a modulus of {:.2g} Pa stresses are rounded by "
                 "{:.1g} Pa",
                 weight, stone.young, rounding),
             "check density and young; stones that stiff are rigid: kinematics: spatial_rigid"});
        return;
    }
}

void refuse_soft_joints(const Case& the_case, Findings& findings)
{
    if (!findings.faults.empty()) return;
    const auto stage = std::find_if(the_case.stages.begin(), the_case.stages.end(),
                                    [](const Stage& each) { return each.type == StageType::static_equilibrium; });
    if (stage == the_case.stages.end()) return;
    const std::vector<SoftStone> soft = too_soft_stones(the_case.model, stage->gravity);
    for (std::size_t i = 0; i < std::min(most_told, soft.size()); ++i)
        findings.faults.push_back(
            {findings.file + ": " + the_case.model.blocks[soft[i].block].name,
             fmt::format("settles by {} under the weight that it carries, {:.2g} % of the width",
                         millimetres(soft[i].depth), 100 * soft[i].share),
             fmt::format("give its joints a contact_stiffness {:g} times as large", std::ceil(soft[i].factor))});
}

}  // namespace voussoir::app::reader
