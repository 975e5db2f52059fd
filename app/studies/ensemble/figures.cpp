#include <fmt/format.h>

#include "app/studies/ensemble/report.h"

namespace voussoir::app::studies::ensemble
{

namespace
{

constexpr std::size_t max_points = 1500;  // of a curve: more than a picture is wide

plots::Curve curve_of(const std::string& name, const std::vector<double>& times,
                      const std::vector<Eigen::Vector3d>& history)
{
    plots::Curve curve{name, {}, {}};
    const std::size_t every = 1 + times.size() / max_points;
    for (std::size_t i = 0; i < times.size(); i += every) {
        curve.x.push_back(times[i]);
        curve.y.push_back(1e3 * history[i].norm());
    }
    return curve;
}

}  // namespace

std::vector<plots::Figure> ensemble_figures(const EnsembleStudy& study)
{
    plots::Figure figure{
        "drift", study.title, fmt::format("{} = {}", study.variation.key, fmt::join(study.variation.values, ", ")),
        {},      true,        {}};
    for (std::size_t point = 0; point < study.points.size(); ++point) {
        plots::Diagram diagram{"time [s]", study.points[point] + " [mm]", {}, {}, false, false, false};
        for (const auto& runs : study.runs)
            for (const MemberRun& run : runs)
                diagram.curves.push_back(curve_of(setting_in_words(study, run.setting), run.recording.times,
                                                  run.recording.values[point]));
        figure.diagrams.push_back(diagram);
    }
    return {figure};
}

}  // namespace voussoir::app::studies::ensemble
