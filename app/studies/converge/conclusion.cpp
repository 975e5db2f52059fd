#include "app/studies/converge/conclusion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "app/results/settings.h"
#include "app/studies/converge/verdict.h"
#include "app/words/figures_in_words.h"

namespace voussoir::app::studies::converge
{
namespace
{

/// Error and uncertainty of a row together; infinite where nothing is known. [-]
double total_error(const Series& series, const SeriesRow& row)
{
    return row.error && row.failure.empty() ? *row.error + series.uncertainty
                                            : std::numeric_limits<double>::infinity();
}

/// A row of a series, in all quantities.
struct Candidate {
    std::size_t series = 0, row = 0;
    std::size_t compared = 0, met = 0;  // quantities that have a value, that are within the tolerance
    double ignorance = 0;               // sum over the quantities of the total errors, each at most 1
    double cpu = 0;                     // s

    /// Most quantities met; of those that meet as many the cheapest, or where none is met the best known.
    bool is_better_than(const Candidate& other) const
    {
        const auto rank = [](const Candidate& c) {
            return std::make_tuple(-static_cast<double>(c.met), c.met > 0 ? 0 : c.ignorance, c.cpu);
        };
        return rank(*this) < rank(other);
    }
};

/// Rows to choose from: all of a series of time steps; without any, the case's own stiffness where it was run.
bool is_choice(const ConvergeStudy& study, const Series& series, const SeriesRow& row)
{
    if (series.varied == Varied::time_step) return true;
    const std::vector<Series>& all = study.quantities.front().series;
    const bool has_steps =
        std::any_of(all.begin(), all.end(), [](const Series& each) { return each.varied == Varied::time_step; });
    const auto is_own = [](const SeriesRow& each) { return each.setting.stiffness_factor == 1; };
    return !has_steps && (is_own(row) || std::none_of(series.rows.begin(), series.rows.end(), is_own));
}

std::optional<Candidate> best_of(const ConvergeStudy& study)
{
    std::optional<Candidate> best;
    const std::vector<Series>& first = study.quantities.front().series;
    for (std::size_t s = 0; s < first.size(); ++s) {
        for (std::size_t r = 0; r < first[s].rows.size(); ++r) {
            if (!is_choice(study, first[s], first[s].rows[r])) continue;
            Candidate candidate{s, r, 0, 0, 0, first[s].rows[r].cost.cpu_to_compare()};
            for (const QuantityStudy& quantity : study.quantities) {
                const Series& series = quantity.series[s];
                if (!series.reference) continue;  // it does not move, or its peak stands for it
                const double error = total_error(series, series.rows[r]);
                candidate.compared += series.rows[r].value.has_value();
                candidate.met += error <= study.tolerance;
                candidate.ignorance += std::min(error, 1.0);
            }
            if (candidate.compared > 0 && (!best || candidate.is_better_than(*best))) best = candidate;
        }
    }
    return best;
}

std::string why_not_known(const Series& series, const SeriesRow& row)
{
    if (!row.failure.empty()) return row.failure;
    if (!row.value) return series.no_order;
    if (series.rows.size() < 2) return "a single run says nothing about its error";
    return fmt::format("uncertain by {}", share_in_words(total_error(series, row)));
}

KnownQuantity knowledge_of(const QuantityStudy& quantity, const Candidate& best)
{
    const Series& series = quantity.series[best.series];
    const SeriesRow& row = series.rows[best.row];
    KnownQuantity known{quantity.name, quantity.unit, row.value, {}, ""};
    const double error = total_error(series, row);
    if (error <= most_uncertain)
        known.within = error;
    else
        known.why_not = why_not_known(series, row);
    return known;
}

/// "time_step: 1 ms", for every dynamic stage that changes.
void add_case_lines(const ConvergeStudy& study, const ConvergeSetting& setting, Conclusion& conclusion)
{
    for (const StudiedStage& stage : study.stages) {
        std::vector<std::pair<std::string, std::string>> keys;
        if (setting.step_factor != 1)
            keys.emplace_back("time_step", words::step_in_words(setting.step_factor * stage.time_step));
        if (setting.step_factor != 1 && stage.step_error > 0)
            keys.emplace_back("step_error",
                              fmt::format("{:g} m", scaled_step_error(stage.step_error, setting.step_factor)));
        if (setting.integrator != stage.integrator)
            keys.emplace_back("integrator", std::string(results::name_of(setting.integrator)));
        if (keys.empty()) continue;
        conclusion.case_lines.push_back(fmt::format("# stages[{}], '{}'", stage.index, stage.name));
        for (const auto& [key, value] : keys) {
            conclusion.case_lines.push_back(fmt::format("{}: {}", key, value));
            conclusion.set_options.push_back(fmt::format("stages[{}].{}={}", stage.index, key, value));
        }
    }
}

std::vector<std::string> stiffness_lines(const ConvergeStudy& study, double factor)
{
    std::vector<std::string> lines;
    for (const StudiedJoint& joint : study.joints) {
        lines.push_back(fmt::format("# joints.{}", joint.name));
        lines.push_back(fmt::format("contact_stiffness_factor: {:g}", factor * joint.stiffness_factor));
    }
    return lines;
}

/// What is said of the joints is said of quantities that are known: of the others it is chance.
std::vector<const QuantityStudy*> known_quantities(const ConvergeStudy& study, const Conclusion& conclusion)
{
    std::vector<const QuantityStudy*> known;
    for (std::size_t q = 0; q < study.quantities.size(); ++q)
        if (conclusion.known[q].within) known.push_back(&study.quantities[q]);
    return known;
}

/// The least factor from the case's own on at which all quantities are within the tolerance of the limit; 0: none.
double rigid_factor(const std::vector<const QuantityStudy*>& known, std::size_t s, double tolerance)
{
    const std::vector<SeriesRow>& rows = known.front()->series[s].rows;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const bool is_rigid = std::all_of(known.begin(), known.end(), [&](const QuantityStudy* quantity) {
            return meets(quantity->series[s], quantity->series[s].rows[r], tolerance);
        });
        if (is_rigid && rows[r].setting.stiffness_factor >= 1) return rows[r].setting.stiffness_factor;
    }
    return 0;
}

std::string rigidity_in_words(double factor, double largest, double tolerance)
{
    const std::string share = fmt::format("{:g} %", 100 * tolerance);
    if (factor == 0)
        return fmt::format(
            "none of these is known to be within {} of rigid joints: if they are meant to be rigid, try "
            "--stiffness-factors {:g},{:g},{:g}",
            share, largest, 4 * largest, 16 * largest);
    if (factor <= 1) return fmt::format("they are within {} of rigid ones", share);
    return fmt::format("if they are meant to be rigid, x {:g} is within {} of that", factor, share);
}

/// What doubling the stiffness changes at most, and the least factor that is rigid enough.
void add_joints(const ConvergeStudy& study, Conclusion& conclusion)
{
    const std::vector<const QuantityStudy*> known = known_quantities(study, conclusion);
    if (known.empty()) return;
    const std::vector<Series>& all = known.front()->series;
    const auto stiffness =
        std::find_if(all.begin(), all.end(), [](const Series& each) { return each.varied == Varied::stiffness; });
    if (stiffness == all.end()) return;
    const std::size_t s = stiffness - all.begin();
    const auto change = [&](const QuantityStudy* quantity) {
        return change_per_doubling(quantity->series[s]).value_or(-1);
    };
    const QuantityStudy* most = *std::max_element(
        known.begin(), known.end(), [&](const auto* a, const auto* b) { return change(a) < change(b); });
    if (change(most) < 0) return;
    const double factor = rigid_factor(known, s, study.tolerance);
    conclusion.remarks.push_back(fmt::format(
        "joints: doubling the contact stiffness changes {} by {}; {}", most->name, share_in_words(change(most)),
        rigidity_in_words(factor, stiffness->rows.back().setting.stiffness_factor, study.tolerance)));
    if (factor > 1) conclusion.joint_lines = stiffness_lines(study, factor);
}

/// Whether the other integrators come to the same in what is known.
void compare_integrators(const ConvergeStudy& study, const Candidate& best, Conclusion& conclusion)
{
    struct Difference {
        const QuantityStudy* quantity = nullptr;
        const Series* other = nullptr;
        double apart = 0;
        bool agrees = true;
    } most;
    for (const QuantityStudy* quantity : known_quantities(study, conclusion)) {
        const Series& own = quantity->series[best.series];
        for (const Series& other : quantity->series) {
            const bool is_other = other.varied == Varied::time_step && other.integrator != own.integrator;
            if (!is_other || !own.reference || !other.reference || !(own.scale > 0)) continue;
            const double apart = std::abs(*own.reference - *other.reference) / own.scale;
            const bool agrees = apart <= own.uncertainty + other.uncertainty * other.scale / own.scale;
            if (most.quantity == nullptr ||
                std::make_tuple(!agrees, apart) > std::make_tuple(!most.agrees, most.apart))
                most = {quantity, &other, apart, agrees};
        }
    }
    if (most.quantity == nullptr) return;
    conclusion.remarks.push_back(fmt::format(
        "{} comes to the same within {} ({}), {}", results::name_of(most.other->integrator),
        share_in_words(most.apart), most.quantity->name,
        most.agrees ? "as the uncertainties allow" : "more than the uncertainties say: trust neither below it"));
}

/// Until when the runs could be compared.
void tell_of_collapse(const ConvergeStudy& study, const Candidate& best, Conclusion& conclusion)
{
    for (const SeriesRow& row : study.quantities.front().series[best.series].rows)
        if (row.collapse) {
            conclusion.remarks.push_back(
                "the values are those before the first collapse; what stands and what falls is for --threshold to "
                "find, and blocks that are meant to move far for --collapse-displacement none");
            return;
        }
}

/// What to do about quantities that no time step settles.
void send_to_ensemble(const ConvergeStudy& study, Conclusion& conclusion)
{
    const bool all_known = std::all_of(conclusion.known.begin(), conclusion.known.end(),
                                       [](const KnownQuantity& known) { return known.within || !known.value; });
    if (all_known || study.joints.empty() || !study.may_be_ensemble) return;
    const StudiedJoint& joint = study.joints.front();
    std::string values;
    for (const double change : {-0.002, -0.001, 0.0, 0.001, 0.002})
        values += fmt::format("{}{:.6g} deg", values.empty() ? "" : ",", joint.friction_degrees * (1 + change));
    conclusion.remarks.push_back(
        fmt::format("what is not known differs from run to run, whatever the time step: take the median of an "
                    "ensemble, voussoir ensemble {} --vary \"joints.{}.friction={}\"",
                    study.case_file, joint.name, values));
}

}  // namespace

Conclusion conclude(const ConvergeStudy& study)
{
    Conclusion conclusion;
    conclusion.tolerance = study.tolerance;
    conclusion.is_static = study.stages.empty();
    const std::optional<Candidate> best = best_of(study);
    if (!best) {
        for (const SeriesRow& row : study.quantities.front().series.front().rows)
            if (conclusion.remarks.empty() && !row.failure.empty()) conclusion.remarks.push_back(row.failure);
        return conclusion;
    }
    conclusion.row = &study.quantities.front().series[best->series].rows[best->row];
    conclusion.meets = best->met == best->compared;
    for (const QuantityStudy& quantity : study.quantities)
        conclusion.known.push_back(knowledge_of(quantity, *best));
    add_case_lines(study, conclusion.row->setting, conclusion);
    if (conclusion.row->setting.stiffness_factor != 1)
        conclusion.joint_lines = stiffness_lines(study, conclusion.row->setting.stiffness_factor);
    tell_of_collapse(study, *best, conclusion);
    compare_integrators(study, *best, conclusion);
    add_joints(study, conclusion);
    send_to_ensemble(study, conclusion);
    return conclusion;
}

}  // namespace voussoir::app::studies::converge
