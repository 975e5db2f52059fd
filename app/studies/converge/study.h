// The whole study: every setting is run once, and every quantity judged in every series of settings.
#pragma once

#include <string>
#include <vector>

#include "app/studies/converge/series.h"

namespace voussoir::app::studies::converge
{

/// One quantity in all series.
struct QuantityStudy {
    std::string name, unit;
    std::vector<Series> series;  // time steps for each integrator, then stiffness
    std::string added;           // why it stands here without having been asked for
};

/// A dynamic stage of the case as it is.
struct StudiedStage {
    int index = 0;  // in the case
    std::string name;
    double time_step = 0;   // s
    double step_error = 0;  // m; 0: steps do not follow it
    Integrator integrator = Integrator::newmark;
};

/// A joint of the case as it is.
struct StudiedJoint {
    std::string name;
    double stiffness_factor = 1, friction_degrees = 0;
};

struct ConvergeStudy {
    std::string case_file, title;
    std::vector<std::string> overrides;  // --set
    std::string collapse_rule;           // in words
    int threads = 1;                     // of every run
    std::vector<QuantityStudy> quantities;
    std::vector<std::string> notes;
    double tolerance = 0.05;  // -, wanted
    std::vector<StudiedStage> stages;
    std::vector<StudiedJoint> joints;
    bool may_be_ensemble = false;  // it has histories, whose medians can be taken
};

/// A series of settings: indices into the list of settings, coarse to fine.
struct SeriesPlan {
    Varied varied = Varied::time_step;
    Integrator integrator = Integrator::newmark;
    std::vector<std::size_t> settings;
};

/// Every setting once, and the series made of them.
struct SettingList {
    std::vector<ConvergeSetting> settings;
    std::vector<SeriesPlan> series;
};

/// @throws InputError when there is nothing to compare: one time step and one stiffness, of a plan that compares
SettingList list_settings(const ConvergePlan& plan);

/// A study of nothing yet, with what the case says of itself.
ConvergeStudy begin_study(const Case& the_case, const CollapseRule& rule);

/// A row before its run is judged.
SeriesRow row_of(const ConvergeSetting& setting, const Case& the_case, const RunCost& cost,
                 const std::string& failure);

/// Runs the settings and judges the quantities. A history that shows no order and meets no tolerance is joined by
/// its peak and its end; where runs collapse an end state is not compared, and its peak stands beside it.
/// @throws Interrupted
ConvergeStudy run_study(const Case& the_case, const SettingList& list, const std::vector<Quantity>& quantities,
                        const CollapseRule& rule, const ConvergeWatch& watch);

}  // namespace voussoir::app::studies::converge
