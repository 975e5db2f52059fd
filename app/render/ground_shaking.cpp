#include "app/render/ground_shaking.h"

#include <algorithm>
#include <map>
#include <utility>

#include "app/results/recorded_motions.h"
#include "libdda/errors.h"

namespace voussoir::app::render
{

using Eigen::Vector3d;

namespace
{

/// Motions by their index, and the axes along which they act.
using Followed = std::vector<std::pair<std::size_t, int>>;

/// For each block what it follows, from "abutment_left x".
std::map<std::size_t, Followed> followed_by_block(const std::vector<results::RecordedMotion>& motions,
                                                  const results::RecordedModel& model)
{
    std::map<std::string, std::size_t> block_named;
    for (const std::int32_t block : model.foundations)
        block_named.emplace(model.block_names[static_cast<std::size_t>(block)], static_cast<std::size_t>(block));
    std::map<std::size_t, Followed> followed;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        for (const std::string& follower : motions[i].followers) {
            if (follower.size() < 3 || follower.back() < 'x' || follower.back() > 'z') continue;
            const auto block = block_named.find(follower.substr(0, follower.size() - 2));
            if (block != block_named.end()) followed[block->second].emplace_back(i, follower.back() - 'x');
        }
    }
    return followed;
}

double value_at(const ShakingAlong& shaking, double time)
{
    const double since = time - shaking.start;
    const std::size_t count = std::min(shaking.times.size(), shaking.acceleration.size());
    if (count == 0 || since < shaking.times.front() || since > shaking.times[count - 1]) return 0;
    const auto end = shaking.times.begin() + static_cast<std::ptrdiff_t>(count);
    const auto after = std::upper_bound(shaking.times.begin(), end, since);
    if (after == end) return shaking.acceleration[count - 1];
    const auto next = static_cast<std::size_t>(after - shaking.times.begin());
    const double from = shaking.times[next - 1], share = (since - from) / (shaking.times[next] - from);
    return (1 - share) * shaking.acceleration[next - 1] + share * shaking.acceleration[next];
}

double largest_of(const GroundShaking& shaking)
{
    double largest = 0;
    for (const ShakingAlong& along : shaking.along)
        for (const double time : along.times)
            largest = std::max(largest, shaking.acceleration(along.start + time).norm());
    return largest;
}

GroundShaking shaking_with(const Followed& followed, const std::vector<results::RecordedMotion>& motions)
{
    GroundShaking shaking;
    for (const auto& [motion, axis] : followed)
        shaking.along.push_back(
            {axis, motions[motion].start, motions[motion].times, motions[motion].acceleration});
    return shaking;
}

}  // namespace

Vector3d GroundShaking::acceleration(double time) const
{
    Vector3d sum = Vector3d::Zero();
    for (const ShakingAlong& one : along) sum[one.axis] += value_at(one, time);
    return sum;
}

std::vector<GroundShaking> shaking_of(const std::filesystem::path& file, const results::RecordedModel& model)
{
    const std::vector<results::RecordedMotion> motions = results::recorded_motions(file);
    std::map<Followed, std::vector<std::size_t>> supports;  // blocks by what they follow
    for (const auto& [block, followed] : followed_by_block(motions, model)) supports[followed].push_back(block);
    if (supports.empty())
        throw InputError("--ground", "no foundation follows a motion in these results", "leave the arrow out");
    std::vector<GroundShaking> shakings;
    double largest = 0;
    for (const auto& [followed, blocks] : supports) {
        GroundShaking shaking = shaking_with(followed, motions);
        for (const std::size_t block : blocks)
            shaking.place += model.centroids[block] / static_cast<double>(blocks.size());
        largest = std::max(largest, largest_of(shaking));
        shakings.push_back(std::move(shaking));
    }
    for (GroundShaking& shaking : shakings) shaking.largest = largest;
    return shakings;
}

}  // namespace voussoir::app::render
