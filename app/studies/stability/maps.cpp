#include "app/studies/stability/maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/words/figures_in_words.h"

namespace voussoir::app::studies::stability
{
namespace
{

using Rgb = std::vector<double>;

const Rgb at_tolerance{0.80, 0.91, 0.72}, far_within{0.10, 0.50, 0.33};
const Rgb refused_color{0.62, 0.70, 0.80}, stopped_color{0.97, 0.78, 0.32}, warned_color{0.90, 0.50, 0.18},
    wrong_color{0.80, 0.15, 0.12};
const Rgb crash_color{0.12, 0.12, 0.14}, timeout_color{0.47, 0.27, 0.58};

/// Dark where the error is a thousandth of the tolerance, pale where it is all of it.
Rgb passed_color(double share)
{
    const double depth = std::clamp(-std::log10(std::max(share, 1e-9)) / 3, 0.0, 1.0);
    Rgb color(3);
    for (int i = 0; i < 3; ++i) color[i] = at_tolerance[i] + depth * (far_within[i] - at_tolerance[i]);
    return color;
}

Rgb color_of(const CellResult& result)
{
    switch (result.outcome) {
        case CellOutcome::passed:
            return passed_color(result.run.error / result.cell.tolerance);
        case CellOutcome::refused:
            return refused_color;
        case CellOutcome::stopped:
            return stopped_color;
        case CellOutcome::warned:
            return warned_color;
        case CellOutcome::wrong:
            return wrong_color;
        case CellOutcome::crash:
            return crash_color;
        case CellOutcome::timeout:
            break;
    }
    return timeout_color;
}

const std::vector<plots::TileKey> keys{{"tolerance / 1000", far_within},
                                       {"at the tolerance", at_tolerance},
                                       {"refused before step one", refused_color},
                                       {"stopped with a diagnosis", stopped_color},
                                       {"beyond it, with a warning", warned_color},
                                       {"wrong: beyond it, no warning", wrong_color},
                                       {"crash", crash_color},
                                       {"beyond its time budget", timeout_color}};

std::string summary_of(const std::vector<const CellResult*>& results)
{
    std::string text = fmt::format("{} cells", results.size());
    for (const CellOutcome outcome :
         {CellOutcome::passed, CellOutcome::refused, CellOutcome::stopped, CellOutcome::warned, CellOutcome::wrong,
          CellOutcome::crash, CellOutcome::timeout}) {
        const auto count = std::count_if(results.begin(), results.end(),
                                         [&](const CellResult* each) { return each->outcome == outcome; });
        if (count > 0) text += fmt::format(", {} {}", count, name_of(outcome));
    }
    return text;
}

std::vector<const CellResult*> results_of(const StabilityScene& scene, const std::vector<CellResult>& results)
{
    std::vector<const CellResult*> found;
    for (const CellResult& result : results)
        if (result.cell.scene == scene.name) found.push_back(&result);
    return found;
}

plots::Figure heat_map(const StabilityScene& scene, const std::vector<const CellResult*>& results)
{
    std::set<double> stiffnesses, steps;
    for (const CellResult* result : results) {
        stiffnesses.insert(result->cell.parameters.at(0).value);
        steps.insert(result->cell.time_step);
    }
    plots::TileMap map;
    map.x_title = "time step";
    map.y_title = "contact stiffness, N/m per contact point";
    map.keys = keys;
    for (const double k : stiffnesses) map.rows.push_back(fmt::format("{:.0e}", k));
    for (const double h : steps) map.columns.push_back(words::step_in_words(h));
    map.width = static_cast<int>(steps.size());
    map.tiles.resize(stiffnesses.size() * steps.size());
    for (const CellResult* result : results) {
        const auto row = std::distance(stiffnesses.begin(), stiffnesses.find(result->cell.parameters[0].value));
        const auto column = std::distance(steps.begin(), steps.find(result->cell.time_step));
        const std::string cost =
            result->outcome == CellOutcome::crash || result->outcome == CellOutcome::timeout
                ? ""
                : fmt::format("{:.2g} s, {} cuts", result->run.cpu_time, result->run.step_cuts);
        map.tiles[static_cast<std::size_t>(row * map.width + column)] = {result_in_words(*result), cost,
                                                                         color_of(*result)};
    }
    plots::Figure figure;
    figure.name = scene.name;
    figure.title = scene.title;
    figure.subtitle = summary_of(results) + fmt::format("; tolerance {}; in each square: error, CPU time, cuts",
                                                        words::error_in_words(results.front()->cell.tolerance));
    figure.maps = {map};
    return figure;
}

constexpr std::size_t squares_in_a_row = 8;

/// What tells a cell from the others of its scene: its values, with their names where these differ.
std::string particulars(const StabilityCell& cell, const StabilityScene& scene)
{
    const bool named = std::any_of(scene.cells.begin(), scene.cells.end(), [&](const StabilityCell& other) {
        return other.parameters.at(0).name != cell.parameters.at(0).name;
    });
    std::string text;
    for (const CellParameter& parameter : cell.parameters)
        text += (text.empty() ? "" : ", ") + (named ? parameter.name + " " : "") + in_words(parameter);
    return text;
}

plots::Tile tile_of(const CellResult& result, const StabilityScene& scene)
{
    const double h = result.cell.time_step;
    return {particulars(result.cell, scene),
            (h > 0 ? words::step_in_words(h) : "static") + ": " + result_in_words(result), color_of(result)};
}

/// Rows of a scene, from the top down; in a square what is particular to it, and its error.
plots::Figure table_map(const std::vector<const StabilityScene*>& scenes, const std::vector<CellResult>& results)
{
    plots::TileMap map;
    map.keys = keys;
    map.width = squares_in_a_row;
    std::vector<const CellResult*> all;
    for (auto scene = scenes.rbegin(); scene != scenes.rend(); ++scene) {
        const std::vector<const CellResult*> own = results_of(**scene, results);
        all.insert(all.end(), own.begin(), own.end());
        for (std::size_t row = (own.size() - 1) / squares_in_a_row + 1; row-- > 0;) {  // from the foot up
            map.rows.push_back(row == 0 ? (*scene)->title : "");
            for (std::size_t i = row * squares_in_a_row; i < (row + 1) * squares_in_a_row; ++i)
                map.tiles.push_back(i < own.size() ? tile_of(*own[i], **scene) : plots::Tile{});
        }
    }
    plots::Figure figure;
    figure.name = "extremes";
    figure.title = "Extreme scenes";
    figure.subtitle = summary_of(all) + "; in each square: parameters, time step and error";
    figure.maps = {map};
    return figure;
}

}  // namespace

std::string result_in_words(const CellResult& result)
{
    if (has_error(result.outcome) && !std::isfinite(result.run.error)) return "no answer";
    return has_error(result.outcome) ? words::error_in_words(result.run.error)
                                     : std::string(name_of(result.outcome));
}

std::vector<plots::Figure> stability_figures(const std::vector<StabilityScene>& scenes,
                                             const std::vector<CellResult>& results)
{
    std::vector<plots::Figure> figures;
    std::vector<const StabilityScene*> others;
    for (const StabilityScene& scene : scenes) {
        const std::vector<const CellResult*> own = results_of(scene, results);
        if (own.empty()) continue;
        if (scene.over_stiffness_and_step)
            figures.push_back(heat_map(scene, own));
        else
            others.push_back(&scene);
    }
    if (!others.empty()) figures.push_back(table_map(others, results));
    return figures;
}

}  // namespace voussoir::app::studies::stability
