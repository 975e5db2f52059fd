#include "app/render/look.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "app/words/look_words.h"
#include "importers/helper/stone_choice.h"
#include "libdda/errors.h"

namespace voussoir::app::render
{

using Eigen::Vector3d;

namespace
{

constexpr double degree = std::numbers::pi / 180;
constexpr double steepest = 89.9 * degree;  // a camera needs to know what is up

using importers::helper::matches_pattern;

/// The stones whose name, or whose group's, has one of the patterns.
void mark(const std::vector<std::string>& patterns, const char* key, const std::vector<std::string>& names,
          const std::vector<std::string>& groups, std::vector<bool>& marks)
{
    if (patterns.empty()) return;
    marks.resize(names.size());
    for (const std::string& pattern : patterns) {
        bool found = false;
        for (std::size_t b = 0; b < names.size(); ++b) {
            if (!matches_pattern(names[b], pattern) &&
                (b >= groups.size() || !matches_pattern(groups[b], pattern)))
                continue;
            marks[b] = found = true;
        }
        if (!found)
            throw InputError(key, "\"" + pattern + "\" is the name of no stone and of no group",
                             "give names, or patterns with * and ?");
    }
}

void cut(const std::string& text, const std::vector<Vector3d>& centroids, std::vector<bool>& hidden)
{
    const std::optional<words::Cut> cut = words::cut_named(text);
    if (!cut) throw InputError("--cut", "\"" + text + "\"", words::cut_expected);
    hidden.resize(centroids.size());
    for (std::size_t b = 0; b < centroids.size(); ++b)
        if (cut->takes(centroids[b])) hidden[b] = true;
}

/// By mass, of the stones that the camera goes with. @param mass (blocks) kg
std::vector<double> followed_stones(const std::string& pattern, const results::RecordedModel& model,
                                    const std::vector<std::string>& groups, const std::vector<double>& mass)
{
    std::vector<bool> marks;
    if (pattern != words::whole_structure)
        mark({pattern}, "--follow", model.block_names, groups, marks);
    else
        marks.assign(model.block_names.size(), true);
    if (pattern == words::whole_structure)
        for (const std::int32_t block : model.foundations) marks[static_cast<std::size_t>(block)] = false;
    std::vector<double> weights(marks.size());
    double all = 0;
    for (std::size_t b = 0; b < marks.size(); ++b)
        if (marks[b]) all += weights[b] = b < mass.size() && mass[b] > 0 ? mass[b] : 1;
    if (!(all > 0)) throw InputError("--follow", "there are foundations alone", "follow nothing");
    for (double& weight : weights) weight /= all;
    return weights;
}

double largest_force(const results::ResultsReader& results)
{
    double most = std::numeric_limits<double>::min();
    for (std::size_t i = 0; i < results.times.size(); ++i)
        for (const JointResultant& contact : results.frame(i).contacts)
            most = std::max(most, contact.force.norm());
    return most;
}

/// The groups that have more than foundations, which are grey.
void colour_by_groups(const std::vector<std::string>& groups, const std::vector<std::int32_t>& group,
                      const results::RecordedModel& model, LookOfRun& of_run)
{
    std::vector<bool> held(group.size(), false);
    for (const std::int32_t block : model.foundations) held[static_cast<std::size_t>(block)] = true;
    std::vector<std::int32_t> place(groups.size() + 1, -1);
    for (std::size_t b = 0; b < group.size(); ++b) {
        std::int32_t& at = place[static_cast<std::size_t>(group[b])];
        if (held[b] || at >= 0) continue;
        at = static_cast<std::int32_t>(of_run.group_names.size());
        of_run.group_names.push_back(groups.empty() ? "" : groups[static_cast<std::size_t>(group[b])]);
    }
    of_run.group.reserve(group.size());
    for (const std::int32_t index : group)
        of_run.group.push_back(std::max(0, place[static_cast<std::size_t>(index)]));
}

Vector3d direction(double azimuth, double elevation)
{
    return {std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
            std::sin(elevation)};
}

/// Where points are while the viewer walks about them: two circles, so that their distance stays.
std::vector<Vector3d> drum_about(const std::vector<Vector3d>& points)
{
    Vector3d low = points[0], high = points[0];
    for (const Vector3d& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Vector3d middle = (low + high) / 2;
    const double radius = (high - low).head<2>().norm() / 2;
    std::vector<Vector3d> drum;
    for (int i = 0; i < 24; ++i)
        for (const double z : {low.z(), high.z()})
            drum.emplace_back(middle.x() + radius * std::cos(15 * i * degree),
                              middle.y() + radius * std::sin(15 * i * degree), z);
    return drum;
}

}  // namespace

void set_view(const std::string& text, Look& look)
{
    const std::optional<words::ViewAngles> view = words::view_named(text);
    if (!view) throw InputError("--view", "\"" + text + "\"", words::view_expected);
    look.azimuth = view->azimuth;
    look.elevation = view->elevation;
}

LookOfRun look_of(const Look& look, const std::filesystem::path& file, const results::ResultsReader& results)
{
    LookOfRun of_run;
    const std::vector<std::string>& names = results.model.block_names;
    const results::Hdf5File open = results::Hdf5File::open(file);
    const std::vector<std::string> groups = open.read_texts("/model/groups");
    std::vector<std::int32_t> group = open.read<std::int32_t>("/model/block_group");
    group.resize(names.size());
    std::vector<std::string> group_of_block;
    group_of_block.reserve(names.size());
    for (std::int32_t& index : group) {
        index = std::clamp(index, 0, std::max(0, static_cast<std::int32_t>(groups.size()) - 1));
        group_of_block.push_back(groups.empty() ? "" : groups[static_cast<std::size_t>(index)]);
    }
    mark(look.hidden, "--hide", names, group_of_block, of_run.hidden);
    mark(look.labels, "--label", names, {}, of_run.labelled);
    for (const std::string& text : look.cuts) cut(text, results.model.centroids, of_run.hidden);
    if (std::find(of_run.hidden.begin(), of_run.hidden.end(), false) == of_run.hidden.end() &&
        !of_run.hidden.empty())
        throw InputError("--hide, --cut", "no stone is left", "hide fewer");
    if (look.groups) colour_by_groups(groups, group, results.model, of_run);
    if (look.forces) of_run.largest_force = largest_force(results);
    if (!look.follow.empty())
        of_run.followed =
            followed_stones(look.follow, results.model, group_of_block, open.read<double>("/model/mass"));
    if (look.ground) of_run.shaking = shaking_of(file, results.model);
    return of_run;
}

Camera look_at(const std::vector<Vector3d>& points, const PictureArea& area, double aspect, View usual,
               const Look& look, double orbited)
{
    Vector3d back = camera_for(points, area, aspect, usual).back;
    if (look.azimuth) back = direction(*look.azimuth, std::clamp(look.elevation.value_or(0), -steepest, steepest));
    if (look.orbit != 0) {
        const double azimuth = std::atan2(back.x(), -back.y()) + orbited;
        back = direction(azimuth, std::asin(std::clamp(back.z(), -1.0, 1.0)));
    }
    const std::vector<Vector3d> seen = look.orbit != 0 ? drum_about(points) : points;
    return look.orthographic ? parallel_camera(seen, area, aspect, back) : camera_from(seen, area, aspect, back);
}

}  // namespace voussoir::app::render
