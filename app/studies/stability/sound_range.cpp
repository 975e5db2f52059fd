#include "app/studies/stability/sound_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "app/words/figures_in_words.h"

namespace voussoir::app::studies::stability
{

namespace
{

constexpr double rounding = 1e-9;  // decades are logarithms

double stiffness_of(const CellResult& result)
{
    return result.cell.parameters.at(0).value;
}

std::vector<const CellResult*> own_of(const StabilityScene& scene, const std::vector<CellResult>& results)
{
    std::vector<const CellResult*> own;
    for (const CellResult& result : results)
        if (result.cell.scene == scene.name) own.push_back(&result);
    return own;
}

bool is_whole_map(const StabilityScene& scene, const std::vector<CellResult>& results)
{
    return scene.over_stiffness_and_step && own_of(scene, results).size() == scene.cells.size();
}

bool all_pass(const std::vector<const CellResult*>& cells, const SoundRange& range)
{
    return std::all_of(cells.begin(), cells.end(), [&](const CellResult* cell) {
        const bool inside = stiffness_of(*cell) >= range.softest && stiffness_of(*cell) <= range.stiffest &&
                            cell->cell.time_step >= range.shortest && cell->cell.time_step <= range.longest;
        return !inside || cell->outcome == CellOutcome::passed;
    });
}

/// Of what is asked of a map, the share that it reaches in the direction in which it reaches less; of equals that
/// of the larger area.
std::pair<double, double> reached(const SoundRange& range)
{
    const double stiffness = range.decades_of_stiffness() / least_decades_of_stiffness;
    const double step = range.decades_of_step() / least_decades_of_step;
    return {std::min(stiffness, step), stiffness * step};
}

}  // namespace

double SoundRange::decades_of_stiffness() const
{
    return std::log10(stiffest / softest);
}

double SoundRange::decades_of_step() const
{
    return std::log10(longest / shortest);
}

bool SoundRange::is_enough() const
{
    return decades_of_stiffness() > least_decades_of_stiffness - rounding &&
           decades_of_step() > least_decades_of_step - rounding;
}

std::optional<SoundRange> sound_range(const StabilityScene& scene, const std::vector<CellResult>& results)
{
    const std::vector<const CellResult*> own = own_of(scene, results);
    std::set<double> stiffnesses, steps;
    for (const CellResult* cell : own) {
        stiffnesses.insert(stiffness_of(*cell));
        steps.insert(cell->cell.time_step);
    }
    std::optional<SoundRange> best;
    for (auto soft = stiffnesses.begin(); soft != stiffnesses.end(); ++soft)
        for (auto stiff = soft; stiff != stiffnesses.end(); ++stiff)
            for (auto shortest = steps.begin(); shortest != steps.end(); ++shortest)
                for (auto longest = shortest; longest != steps.end(); ++longest) {
                    const SoundRange range{*soft, *stiff, *shortest, *longest};
                    if (all_pass(own, range) && (!best || reached(range) > reached(*best))) best = range;
                }
    return best;
}

std::string sound_range_in_words(const StabilityScene& scene, const std::vector<CellResult>& results)
{
    if (!is_whole_map(scene, results)) return "";
    const std::optional<SoundRange> range = sound_range(scene, results);
    if (!range) return scene.name + " holds nowhere";
    return fmt::format("{} works from {:.0e} to {:.0e} N/m and from {} to {} ({:.2g} and {:.2g} decades)",
                       scene.name, range->softest, range->stiffest, words::step_in_words(range->shortest),
                       words::step_in_words(range->longest), range->decades_of_stiffness(),
                       range->decades_of_step());
}

bool holds_too_little(const StabilityScene& scene, const std::vector<CellResult>& results)
{
    if (!is_whole_map(scene, results)) return false;
    const std::optional<SoundRange> range = sound_range(scene, results);
    return !range || !range->is_enough();
}

}  // namespace voussoir::app::studies::stability
