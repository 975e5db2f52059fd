// All that a report is made from: one results file, and the summary in it or beside it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/report/bars.h"
#include "app/report/course.h"
#include "app/report/mechanism.h"
#include "app/results/recorded_motions.h"
#include "app/results/results_reader.h"
#include "app/results/run_end.h"

namespace voussoir::app::report
{

/// Numbers in named columns, row by row.
struct Columns {
    std::vector<std::string> names;
    std::vector<double> values;  // (rows x names)

    std::size_t rows() const { return names.empty() ? 0 : values.size() / names.size(); }
    /// @throws InputError when there is no such column
    std::vector<double> column(const std::string& name) const;
};

struct RecordedMaterial {
    std::string name;
    double density = 0, young = 0, poisson = 0;  // kg/m3, Pa, -
    std::string damping = "none";                // in words
};

struct RecordedJointMaterial {
    std::string name;
    double friction_angle = 0, cohesion = 0, tensile_strength = 0;  // rad, Pa, Pa
    std::string stiffness, face;  // in words; empty in results of earlier versions
    double relaxation_time = 0;   // s, of its dashpots
};

struct RunRecord {
    explicit RunRecord(const std::filesystem::path& results_file);

    std::filesystem::path file;
    results::ResultsReader results;
    results::RunEnd end;
    std::optional<bool> failed;  // by its verdict, or it collapsed or gave up at a mechanism; nothing: not known
    std::string standing, verdict;  // as the summary names and words it; empty: it has none
    std::string summary;            // JSON text; "{}" of a run that was killed
    std::string case_file, case_text, engine, settings;
    std::vector<std::string> overrides, defaults, warnings, left_out;
    std::vector<std::string> doubts;  // those of the warnings that the run adds to those of the case
    std::vector<std::string> groups;
    std::vector<std::int32_t> block_group;
    std::vector<double> mass, volume;                   // kg, m3
    std::vector<double> joint_area, joint_facing_area;  // m2, at the start
    std::vector<RecordedMaterial> materials;
    std::vector<RecordedJointMaterial> joint_materials;
    std::vector<results::RecordedMotion> motions;
    std::vector<std::string>
        motion_descriptions;  // file, scale, filters and window of each that the case asks for
    std::vector<BarCourse> bars;
    Columns energy, steps;  // one row a frame
    Columns histories;      // one row a step; no names where the case has none
    Course course;
    Mechanism mechanism;
};

}  // namespace voussoir::app::report
