#include "app/results/histories.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <utility>

#include "app/results/atomic_file.h"
#include "app/results/scene_vectors.h"
#include "app/results/surface_mesh.h"
#include "app/words/csv_cell.h"
#include "libdda/analysis/bar_forces.h"
#include "libdda/errors.h"

namespace voussoir::app::results
{

using Eigen::Vector3d;

namespace
{

int block_named(const Model& model, const HistoryPoint& point)
{
    const auto found = std::find_if(model.blocks.begin(), model.blocks.end(),
                                    [&](const Block& block) { return block.name == point.block; });
    if (found == model.blocks.end()) {
        throw InputError("output.histories." + point.name, "block \"" + point.block + "\"",
                         "name a block of the model");
    }
    return static_cast<int>(found - model.blocks.begin());
}

/// A name that cannot break the line it stands in.
std::string csv_safe(std::string name)
{
    for (char& c : name) {
        if (c == ',' || c == '"' || c == '\n' || c == '\r') c = '_';
    }
    return name;
}

std::string lines_of(const std::vector<double>& rows, std::size_t columns)
{
    std::string text;
    for (std::size_t i = 0; i < rows.size(); ++i)
        fmt::format_to(std::back_inserter(text), "{}{}", rows[i], (i + 1) % columns == 0 ? '\n' : ',');
    return text;
}

}  // namespace

MaterialPoint material_point(const Model& model, const HistoryPoint& history)
{
    const int block = block_named(model, history);
    if (!history.point) return {block, Vector3d::Zero()};
    return {block, *history.point - model.origin - model.blocks[block].moments.centroid};
}

Histories::Histories(const Case& the_case, Foot foot)
    : model_(the_case.model), foot_(std::move(foot)), has_foot_(!model_.foundations.empty() || foot_.is_on_soil())
{
    const OutputOptions& output = the_case.output;
    if (output.histories.empty() && output.bar_histories.empty()) return;
    columns = {"time [s]"};
    const std::vector<std::string> axes = axis_names(model_.kinematics);
    for (const HistoryPoint& point : output.histories) {
        points_.push_back(material_point(model_, point));
        const std::string name = csv_safe(point.name);
        for (const std::string& axis : axes) columns.push_back(fmt::format("{} u{} [m]", name, axis));
        for (const std::string& axis : axes) columns.push_back(fmt::format("{} v{} [m/s]", name, axis));
    }
    for (const BarHistory& history : output.bar_histories) {
        bars_.push_back(history.bar);
        const std::string name = csv_safe(history.name);
        columns.push_back(name + " tension [N]");
        columns.push_back(name + " shear [N]");
        columns.push_back(name + " elongation [m]");
    }
    if (has_foot_) {
        for (const std::string& axis : axes) columns.push_back(fmt::format("ground u{} [m]", axis));
    }
}

void Histories::create(const std::filesystem::path& path, const std::vector<double>& rows)
{
    if (columns.empty()) return;
    path_ = path;
    std::string heading;
    for (const std::string& column : columns) heading += (heading.empty() ? "" : ",") + words::csv_cell(column);
    write_atomically(path_, heading + "\n" + lines_of(rows, columns.size()));
    stream_.open(path_, std::ios::app);
    if (!stream_) refuse_writing(path_, errno);
}

void Histories::line(const State& state)
{
    if (columns.empty()) return;
    pending_.push_back(state.time);
    for (const MaterialPoint& point : points_) {
        append_vector(pending_, displacement_of(model_, state, point), model_.kinematics);
        append_vector(pending_, velocity_of(model_, state, point), model_.kinematics);
    }
    if (!bars_.empty()) {
        const std::vector<BarNow> bars = bars_now(model_, state);
        for (const int bar : bars_)
            pending_.insert(pending_.end(), {bars[bar].axial, bars[bar].shear, bars[bar].elongation});
    }
    if (has_foot_) append_vector(pending_, foot_.displacement(model_, state), model_.kinematics);
}

std::vector<double> Histories::take()
{
    taken_.insert(taken_.end(), pending_.begin(), pending_.end());
    return std::exchange(pending_, {});
}

void Histories::flush()
{
    if (taken_.empty()) return;
    errno = 0;
    if (!(stream_ << lines_of(taken_, columns.size()) << std::flush))
        refuse_writing(path_, errno == 0 ? EIO : errno);
    taken_.clear();
}

}  // namespace voussoir::app::results
