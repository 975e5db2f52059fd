#include "app/studies/ensemble/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

#include "app/studies/converge/measured_run.h"
#include "app/words/figures_in_words.h"

namespace voussoir::app::studies::ensemble
{

namespace
{

/// The runs still to do, taken one after another by as many threads as there are jobs.
class Queue
{
 public:
    Queue(const std::vector<Case>& members, const EnsembleWatch& watch, EnsembleStudy& study)
        : members_(members), watch_(watch), study_(study)
    {
        for (std::size_t s = 0; s < study.settings.size(); ++s)
            for (std::size_t m = 0; m < members.size(); ++m) order_.emplace_back(s, m);
        // The longest first, so that no thread is left alone with one at the end.
        std::stable_sort(order_.begin(), order_.end(), [&](const auto& a, const auto& b) {
            return study.settings[a.first].step_factor < study.settings[b.first].step_factor;
        });
    }

    void work()
    {
        try {
            for (std::size_t i = next_++; i < order_.size() && !stopped(); i = next_++)
                finish(order_[i].first, order_[i].second);
        } catch (...) {
            const std::lock_guard hold(lock_);
            failure_ = std::current_exception();
            stopped_ = true;
        }
    }

    /// After all threads have ended. @throws what a run threw, or Interrupted
    void rethrow() const
    {
        if (failure_) std::rethrow_exception(failure_);
        if (stopped_) throw converge::Interrupted();
    }

 private:
    bool stopped()
    {
        if (watch_.stop && watch_.stop()) stopped_ = true;
        return stopped_;
    }

    void finish(std::size_t setting, std::size_t member)
    {
        MemberRun run = run_member(members_[member], study_.settings[setting], study_.choices.limit,
                                   [this] { return stopped(); });
        run.setting = setting;
        run.member = member;
        const std::lock_guard hold(lock_);
        ++done_;
        if (watch_.finished && !stopped_) watch_.finished(run, done_, static_cast<int>(order_.size()));
        study_.runs[setting][member] = std::move(run);
    }

    const std::vector<Case>& members_;
    const EnsembleWatch& watch_;
    EnsembleStudy& study_;
    std::vector<std::pair<std::size_t, std::size_t>> order_;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> stopped_ = false;
    std::mutex lock_;
    int done_ = 0;
    std::exception_ptr failure_;
};

void run_all(const std::vector<Case>& members, const EnsembleWatch& watch, EnsembleStudy& study)
{
    Queue queue(members, watch, study);
    {
        const auto runs = static_cast<int>(study.settings.size() * members.size());
        const int jobs = std::min(study.choices.jobs, runs);
        std::vector<std::jthread> threads;
        threads.reserve(jobs);
        for (int i = 0; i < jobs; ++i) threads.emplace_back([&] { queue.work(); });
    }
    queue.rethrow();
}

std::vector<converge::ConvergeSetting> settings_of(const Integrator integrator, double stiffness_factor)
{
    std::vector<converge::ConvergeSetting> settings{{integrator, 1, 1}, {integrator, 0.5, 1}};
    if (stiffness_factor != 1) settings.push_back({integrator, 1, stiffness_factor});
    return settings;
}

/// A study of nothing yet, with what the case says of itself.
EnsembleStudy begin_ensemble(const Case& member, const Variation& variation, const EnsembleChoices& choices)
{
    const StepControl& control = converge::first_dynamic_stage(member).control;
    EnsembleStudy study;
    study.case_file = member.file.string();
    study.title = member.title;
    study.overrides.assign(member.overrides.begin(), std::prev(member.overrides.end()));  // the last is its own
    study.variation = variation;
    study.choices = choices;
    study.time_step = control.time_step;
    study.settings = settings_of(control.integrator, choices.stiffness_factor);
    for (const HistoryPoint& point : member.output.histories) study.points.push_back(point.name);
    for (const MotionNote& motion : member.motions) study.motions.push_back(motion.description);
    study.warnings = member.warnings;
    for (const EnsembleMeasure& measure : measures_of(member, choices.limit))
        study.measures.emplace_back().measure = measure;
    return study;
}

void collect_values(EnsembleStudy& study)
{
    for (const std::vector<MemberRun>& runs : study.runs) {
        for (MeasureStudy& measure : study.measures) measure.values.emplace_back();
        for (const MemberRun& run : runs) {
            const std::vector<double> values = values_of(run);
            for (std::size_t i = 0; i < values.size(); ++i) study.measures[i].values.back().push_back(values[i]);
        }
    }
}

}  // namespace

void judge(double tolerance, MeasureStudy& study)
{
    for (const std::vector<double>& values : study.values) {
        study.medians.push_back(median_of(values));
        study.ranges.push_back(range_of(values));
    }
    const double coarse = study.medians[0], fine = study.medians[1];
    study.difference = coarse == fine ? 0 : std::abs(coarse - fine);
    // Of both steps, for the range of one sample of five may be small by chance.
    const double mean = 0.5 * (study.ranges[0] + study.ranges[1]), spread = std::isfinite(mean) ? mean : 0;
    study.allowed = std::max(spread, std::isfinite(fine) ? tolerance * std::abs(fine) : 0);
    study.agrees = study.difference <= study.allowed && std::isfinite(study.difference);
}

int EnsembleStudy::given_up() const
{
    int count = 0;
    for (std::size_t setting : {0, 1})
        for (const MemberRun& run : runs[setting]) count += !run.failure.empty();
    return count;
}

bool EnsembleStudy::agrees() const
{
    return given_up() == 0 &&
           std::all_of(measures.begin(), measures.end(), [](const MeasureStudy& each) { return each.agrees; });
}

std::string setting_in_words(const EnsembleStudy& study, std::size_t setting)
{
    const converge::ConvergeSetting& each = study.settings[setting];
    std::string words = words::step_in_words(each.step_factor * study.time_step);
    if (each.stiffness_factor != 1) words += fmt::format(", contact stiffness x {:g}", each.stiffness_factor);
    return words;
}

EnsembleStudy run_ensemble(const std::vector<Case>& members, const Variation& variation,
                           const EnsembleChoices& choices, const EnsembleWatch& watch)
{
    EnsembleStudy study = begin_ensemble(members.front(), variation, choices);
    study.runs.assign(study.settings.size(), std::vector<MemberRun>(members.size()));
    run_all(members, watch, study);
    collect_values(study);
    for (MeasureStudy& measure : study.measures) judge(choices.tolerance, measure);
    return study;
}

}  // namespace voussoir::app::studies::ensemble
