#include "app/studies/converge/recorder.h"

#include <algorithm>
#include <limits>

#include "app/results/histories.h"

namespace voussoir::app::studies::converge
{

using Eigen::Vector3d;

namespace
{

double collapse_distance(const CollapseRule& rule, const Model& model, int block)
{
    if (rule.length) return *rule.length;
    if (rule.sizes) return *rule.sizes * size_of(model, block);
    return std::numeric_limits<double>::infinity();
}

}  // namespace

Recorder::Recorder(const Case& the_case, const std::vector<Quantity>& channels, const CollapseRule& rule)
    : case_(the_case), foot_(the_case.model, joints_at_start(the_case.model, initial_state(the_case.model)))
{
    const Model& model = the_case.model;
    std::vector<bool> held(model.blocks.size(), false);
    if (foot_.is_on_soil()) held = ground_marks(model);
    for (const Foundation& foundation : model.foundations) held[foundation.block] = foundation.fully_held();
    for (int block = 0; block < static_cast<int>(model.blocks.size()); ++block) {
        if (held[block]) continue;
        blocks_.push_back(block);
        collapse_distance_.push_back(collapse_distance(rule, model, block));
    }
    drift_.assign(blocks_.size(), Vector3d::Zero());
    for (const Quantity& quantity : channels) {
        channels_.push_back({quantity, {}});
        if (quantity.point >= 0)
            channels_.back().point = results::material_point(model, the_case.output.histories[quantity.point]);
    }
    recording.values.resize(channels.size());
    recording.extents.assign(channels.size(), 0);
    step(initial_state(model));
}

void Recorder::step(const State& state)
{
    const Vector3d ground = foot_.displacement(case_.model, state);
    follow_blocks(state, ground);
    look_for_collapse(state);
    // In the initial state time does not pass, nor in a static stage: what it ends with replaces what was before.
    const bool moving = state.time > 0;
    if (!moving) remember_rest(state, ground);
    const bool replaces = !recording.times.empty() && state.time <= recording.times.back();
    if (!replaces) recording.times.push_back(state.time);
    for (std::size_t i = 0; i < channels_.size(); ++i) {
        std::vector<Vector3d>& values = recording.values[i];
        if (replaces) values.pop_back();
        const Vector3d value = value_of(channels_[i], state, ground);
        const int component = channels_[i].quantity.component;
        recording.extents[i] = std::max(recording.extents[i], value.norm());
        values.push_back(component < 0 ? value : Vector3d(value[component], 0, 0));
    }
}

void Recorder::follow_blocks(const State& state, const Vector3d& ground)
{
    for (std::size_t i = 0; i < blocks_.size(); ++i)
        drift_[i] = displacement_of(case_.model, state, {blocks_[i], Vector3d::Zero()}) - ground;
}

void Recorder::look_for_collapse(const State& state)
{
    for (std::size_t i = 0; i < blocks_.size() && !collapse; ++i)
        if (drift_[i].norm() > collapse_distance_[i])
            collapse = Collapse{state.time, case_.model.blocks[blocks_[i]].name};
}

void Recorder::remember_rest(const State& state, const Vector3d& ground)
{
    rest_ = drift_;
    for (Channel& channel : channels_)
        if (channel.quantity.field == Field::drift)
            channel.rest = displacement_of(case_.model, state, channel.point) - ground;
}

Vector3d Recorder::value_of(const Channel& channel, const State& state, const Vector3d& ground) const
{
    Vector3d value = Vector3d::Zero();
    switch (channel.quantity.field) {
        case Field::displacement:
            value = displacement_of(case_.model, state, channel.point);
            break;
        case Field::drift:
            value = displacement_of(case_.model, state, channel.point) - ground - channel.rest;
            break;
        case Field::velocity:
            value = velocity_of(case_.model, state, channel.point);
            break;
        case Field::largest_drift:
            for (std::size_t i = 0; i < blocks_.size(); ++i)
                value.x() = std::max(value.x(), (drift_[i] - rest_[i]).norm());
            break;
    }
    return value;
}

}  // namespace voussoir::app::studies::converge
