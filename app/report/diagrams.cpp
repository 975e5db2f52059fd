#include "app/report/diagrams.h"

#include <algorithm>

#include "app/report/curves.h"
#include "app/report/energy_table.h"
#include "app/report/point_history.h"
#include "records/measures/response_spectrum.h"

namespace voussoir::app::report
{
namespace
{

using plots::Curve;
using plots::Diagram;

std::string component_of(const results::RecordedMotion& motion)
{
    const std::string follower = motion.followers.empty() ? "?" : motion.followers.front();
    return follower.substr(follower.rfind(' ') + 1);
}

void add_motion(const RunRecord& record, std::vector<NamedFigure>& figures)
{
    std::vector<Diagram> accelerograms;
    Diagram spectra;
    spectra.x_title = "period [s]";
    spectra.y_title = "pseudo-acceleration [m/s²]";
    spectra.logarithmic_y = spectra.marks = false;
    for (const results::RecordedMotion& motion : record.motions) {
        if (motion.times.size() < 2 || accelerograms.size() == 6) continue;
        accelerograms.push_back(over_time("a" + component_of(motion) + " [m/s²]",
                                          {thinned(component_of(motion), motion.times, motion.acceleration)}));
        records::Channel channel;
        channel.time_step = motion.times[1] - motion.times[0];
        channel.samples = motion.acceleration;
        channel.unit_in_file = "m/s2";
        const auto periods = records::measures::logarithmic_periods(std::max(0.03, channel.time_step), 4, 120);
        const auto spectrum = records::measures::response_spectrum(channel, periods);
        Curve curve;
        curve.name = component_of(motion);
        curve.x = spectrum.periods;
        curve.y = spectrum.pseudo_acceleration;
        spectra.curves.push_back(curve);
    }
    if (accelerograms.empty()) return;
    figures.push_back({figure_of("motion", "Ground acceleration", accelerograms), "Ground motion",
                       "Acceleration of the ground as applied."});
    figures.push_back({figure_of("spectrum", "Response spectra, 5 % damping", {spectra}), "Ground motion",
                       "Response spectra of the motions as applied, 5 % damping."});
}

void add_histories(const RunRecord& record, std::vector<NamedFigure>& figures)
{
    if (record.histories.names.empty() || record.histories.rows() < 2) return;
    std::vector<Diagram> diagrams;
    for (const char* component : {"ux", "uy", "uz"}) {
        std::vector<Curve> curves;
        for (const std::string& name : record.histories.names) {
            const std::size_t at = name.find(std::string(" ") + component);
            if (at == std::string::npos || curves.size() == 8 || is_of_foot(name)) continue;
            const PointHistory history = point_history(record, name);
            curves.push_back(thinned(name.substr(0, at), history.times, history.moved, 1e-3));
        }
        if (!curves.empty()) diagrams.push_back(over_time(std::string(component) + " [mm]", curves));
    }
    if (diagrams.empty()) return;
    figures.push_back(
        {figure_of("histories",
                   "Displacements of the chosen points, " + results::counted_from(record.results.model), diagrams),
         "Histories", "Displacements " + results::counted_from(record.results.model) + "."});
}

void add_course(const RunRecord& record, std::vector<NamedFigure>& figures)
{
    const Course& course = record.course;
    if (course.times.size() < 2 || !(course.times.back() > course.times.front())) return;
    figures.push_back({figure_of("course", "The largest of each at every moment",
                                 {over_time("displacement [mm]",
                                            {thinned("displacement", course.times, course.displacement, 1e-3)}),
                                  over_time("joints [mm]", {thinned("opening", course.times, course.opening, 1e-3),
                                                            thinned("slip", course.times, course.slip, 1e-3)})}),
                       "Histories",
                       "The largest displacement (" + results::counted_from(record.results.model) +
                           "), opening and slip at every stored moment. Openings are "
                           "measured across the joint as it has turned: when a stone tumbles, that of its joint "
                           "may fall again."});
    Diagram shear;
    shear.x_title = "drift of the highest stone [mm]";
    shear.y_title = "base shear [kN]";
    shear.logarithmic_x = shear.logarithmic_y = shear.marks = false;
    for (const int axis : {0, 1}) {
        Curve curve;
        curve.name = axis == 0 ? "x" : "y";
        double largest = 0;
        for (std::size_t i = 0; i < course.times.size(); ++i) {
            curve.x.push_back(1e3 * course.drift[i][axis]);
            curve.y.push_back(-course.base_force[i][axis] / 1e3);
            largest = std::max(largest, std::abs(curve.y.back()));
        }
        if (largest > 0) shear.curves.push_back(curve);
    }
    if (shear.curves.empty()) return;
    figures.push_back({figure_of("base_shear", "Base shear against drift", {shear}), "Histories",
                       "What the structure exerts on its foundations, against the drift of its highest stone."});
}

/// Of the bars that came closest to yielding the force in which they did, and their strength in it.
void add_bars(const RunRecord& record, std::vector<NamedFigure>& figures)
{
    constexpr std::size_t most = 4;
    const std::vector<double>& times = record.course.times;
    if (times.size() < 2 || !(times.back() > times.front())) return;
    std::vector<Diagram> diagrams;
    for (const BarCourse* bar : by_use(record.bars)) {
        if (diagrams.size() == most || bar->tension.size() != times.size()) break;
        const BarForce kind = bar->governing();
        std::vector<double> force = kind == BarForce::shear ? bar->shear : bar->tension;
        if (kind == BarForce::compression)
            for (double& value : force) value = -value;
        diagrams.push_back(
            over_time(std::string(name_of(kind)) + " [kN]", {thinned(bar->name, times, force, 1e3)}));
        if (bar->use()) diagrams.back().levels = {{"strength", bar->strength[static_cast<int>(kind)] / 1e3}};
    }
    if (diagrams.empty()) return;
    figures.push_back({figure_of("bars", "The bars that came closest to yielding", diagrams), bars_title,
                       "Force in the bars that came closest to yielding, with their strength."});
}

/// The balance of the energy; what stays zero is left out.
std::vector<Curve> balance_curves(const RunRecord& record)
{
    const std::vector<std::string>& names = record.energy.names;
    const std::vector<EnergyCurve> parts = energy_curves();
    std::vector<Curve> curves;
    for (const auto& [words, terms] : parts) {
        std::vector<double> sum(record.course.times.size(), 0.0);
        for (const std::string& term : terms) {
            if (std::find(names.begin(), names.end(), term) == names.end()) continue;
            const std::vector<double> of = record.energy.column(term);
            for (std::size_t i = 0; i < std::min(sum.size(), of.size()); ++i) sum[i] += of[i];
        }
        if (std::all_of(sum.begin(), sum.end(), [](double value) { return value == 0; })) continue;
        curves.push_back(thinned(words, record.course.times, sum, 1e3));
        curves.back().is_reference = words == parts.front().words;
    }
    return curves;
}

void add_computation(const RunRecord& record, std::vector<NamedFigure>& figures)
{
    const std::vector<double>& times = record.course.times;
    if (times.size() < 3 || !(times.back() > times.front())) return;
    figures.push_back({figure_of("energies", "Energies", {over_time("energy [kJ]", balance_curves(record))}),
                       "How well it was computed",
                       "Energies put in (with what was there at the start), stored and lost."});
    const std::vector<double> steps = record.steps.column("steps"),
                              iterations = record.steps.column("open_close_iterations");
    std::vector<double> when, size, each;
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (!(times[i] > times[i - 1]) || !(steps[i] > steps[i - 1])) continue;
        when.push_back(times[i]);
        size.push_back(1e3 * (times[i] - times[i - 1]) / (steps[i] - steps[i - 1]));
        each.push_back((iterations[i] - iterations[i - 1]) / (steps[i] - steps[i - 1]));
    }
    if (when.size() < 2) return;
    figures.push_back({figure_of("steps", "Steps",
                                 {over_time("step size [ms]", {thinned("mean step size", when, size)}),
                                  over_time("iterations a step", {thinned("open-close iterations", when, each)})}),
                       "How well it was computed", "Mean step size and iterations between two stored frames."});
}

}  // namespace

std::vector<NamedFigure> diagrams_of(const RunRecord& record)
{
    std::vector<NamedFigure> figures;
    add_motion(record, figures);
    add_histories(record, figures);
    add_course(record, figures);
    add_bars(record, figures);
    add_computation(record, figures);
    return figures;
}

}  // namespace voussoir::app::report
