// histories.csv: one line for each accepted step.
#pragma once

#include <filesystem>
#include <fstream>
#include <vector>

#include "app/case/case.h"
#include "libdda/analysis/ground.h"
#include "libdda/analysis/material_point.h"
#include "libdda/model/state.h"

namespace voussoir::app::results
{

/// The point of a model that a case's history follows.
/// @throws InputError when it names an unknown block
MaterialPoint material_point(const Model& model, const HistoryPoint& history);

/// Displacement and velocity of every history point, and the displacement of the foot of the structure if it has
/// foundations or stands on soil.
/// Lines are held in memory until flush(), of those that were taken. Without history points nothing is created.
class Histories
{
 public:
    /// @throws InputError when a point names an unknown block
    Histories(const Case& the_case, Foot foot);

    /// Makes the file with the lines that an earlier run wrote (rows x columns.size()), all or none of them.
    /// @throws InputError when it cannot be written
    void create(const std::filesystem::path& path, const std::vector<double>& rows);

    void line(const State& state);
    /// The lines since the last call (rows x columns.size()), for results.h5.
    std::vector<double> take();
    /// Writes the lines taken so far to the file.
    void flush();
    std::size_t held_bytes() const { return (pending_.size() + taken_.size()) * sizeof(double); }

    std::vector<std::string> columns;  // "time [s]", "crown ux [m]", ...; empty without history points

 private:
    const Model& model_;
    Foot foot_;
    bool has_foot_;
    std::filesystem::path path_;
    std::vector<MaterialPoint> points_;
    std::vector<int> bars_;  // indices into Model::bars
    std::vector<double> pending_, taken_;
    std::ofstream stream_;
};

}  // namespace voussoir::app::results
