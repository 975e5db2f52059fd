// Statistics in place of histories: members that differ by next to nothing, at step h and h / 2.
//
// Where blocks rock and slide, two runs that differ by rounding part at some impact and stay apart; no history
// converges, whatever the method. What a time step must not change is the distribution: the medians over the
// members at h and at h / 2 may differ by no more than the members among themselves.
#pragma once

#include <string>
#include <vector>

#include "app/studies/ensemble/measures.h"
#include "app/studies/ensemble/variation.h"

namespace voussoir::app::studies::ensemble
{

struct EnsembleChoices {
    double limit = 1e-3;          // m, a joint that is open by more counts
    double stiffness_factor = 2;  // of the sensitivity; 1 leaves it out
    double tolerance = 0.1;       // -, of the median, where the members differ by less
    int jobs = 1;                 // runs side by side, each on one thread
};

/// A measure at all settings.
struct MeasureStudy {
    EnsembleMeasure measure;
    std::vector<std::vector<double>> values;  // (settings x members)
    std::vector<double> medians, ranges;      // (settings)
    double difference = 0, allowed = 0;       // of the medians at h and h / 2; what they may differ by
    bool agrees = false;
};

/// The medians at h and h / 2 agree when they differ by less than the members do among themselves (the mean of
/// their ranges at the two steps), or by less than the tolerance. Where both are infinite, half the members and
/// more collapsed at either step; where only some collapsed there is no spread, and the tolerance decides.
/// @param study with its values; medians, ranges and the verdict are filled in
void judge(double tolerance, MeasureStudy& study);

struct EnsembleStudy {
    std::string case_file, title;
    std::vector<std::string> overrides;
    Variation variation;
    EnsembleChoices choices;
    double time_step = 0;                             // s, of the first dynamic stage of the case
    std::vector<converge::ConvergeSetting> settings;  // h, h / 2, and the stiffness
    std::vector<std::string> points;                  // of the histories
    std::vector<std::vector<MemberRun>> runs;         // (settings x members)
    std::vector<MeasureStudy> measures;
    std::vector<std::string> motions;   // what shook it
    std::vector<std::string> warnings;  // of reading the case, repairs included

    int given_up() const;  // of the runs that are judged
    bool agrees() const;
};

/// What a study tells while it runs, and asks, from the threads of the runs.
struct EnsembleWatch {
    std::function<void(const MemberRun&, int done, int of)> finished;  // called by one thread at a time
    std::function<bool()> stop;  // true ends the study; called by all threads at any time
};

/// "2 ms", "1 ms", "2 ms, contact stiffness x 2".
std::string setting_in_words(const EnsembleStudy& study, std::size_t setting);

/// @throws Interrupted when `watch.stop` says so
EnsembleStudy run_ensemble(const std::vector<Case>& members, const Variation& variation,
                           const EnsembleChoices& choices, const EnsembleWatch& watch);

}  // namespace voussoir::app::studies::ensemble
