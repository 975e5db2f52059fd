#include "libdda/analysis/longest_step.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "libdda/analysis/trust.h"

namespace voussoir
{

namespace
{

constexpr double most_beside_the_motion = 0.05;  // of its accelerations
constexpr int most_halvings = 5;

// A step costs a block 40 microseconds or more, in which a sparse factorisation does 2e4 operations; the search
// may take a hundredth of the steps, and of a short run some ten milliseconds.
constexpr double work_of_a_block_in_a_step = 2e4;
constexpr double share_of_the_run = 0.01;
constexpr double always_allowed = 5e6;

bool leaves_vibrations_alone(const NaturalModes& modes, const Stage& stage)
{
    using Kind = TrustFinding::Kind;
    const Trust trust = trust_in({false, modes, {}}, {stage}, {});
    return std::none_of(trust.findings.begin(), trust.findings.end(), [](const TrustFinding& finding) {
        return finding.kind == Kind::algorithmic_damping || finding.kind == Kind::period;
    });
}

bool follows(const GroundMotion& motion, double duration, double step)
{
    double off = 0, all = 0;
    double before = motion.acceleration(0);
    const auto steps = static_cast<std::int64_t>(duration / step);
    for (std::int64_t i = 1; i <= steps; ++i) {
        const double time = static_cast<double>(i) * step;
        const double now = motion.acceleration(time), between = motion.acceleration(time - step / 2);
        off += std::pow(between - (before + now) / 2, 2);
        all += between * between;
        before = now;
    }
    return off <= most_beside_the_motion * most_beside_the_motion * all;
}

bool follows_motions(const Stage& stage)
{
    const double step = stage.control.time_step;
    const auto follows_it = [&](const auto& use) {
        return !use.motion || follows(*use.motion, std::min(stage.duration, use.motion->duration()), step);
    };
    return std::all_of(stage.motions.begin(), stage.motions.end(), follows_it) &&
           std::all_of(stage.body_accelerations.begin(), stage.body_accelerations.end(), follows_it) &&
           std::all_of(stage.incoming_waves.begin(), stage.incoming_waves.end(), follows_it);
}

bool are_unknown(const NaturalModes& modes)
{
    return modes.outcome == ModesOutcome::too_costly || modes.outcome == ModesOutcome::failed;
}

}  // namespace

double longest_step(const NaturalModes& modes, const Stage& stage)
{
    if (are_unknown(modes)) return step_of_unknown_modes;
    Stage with = stage;
    for (const double step : usual_steps) {
        with.control.time_step = step;
        if (leaves_vibrations_alone(modes, with) && follows_motions(with)) return step;
    }
    return usual_steps.back();
}

int halvings_for(const NaturalModes& modes, const Stage& stage)
{
    if (are_unknown(modes)) return 0;
    Stage with = stage;
    int halvings = 0;
    while (halvings < most_halvings && !leaves_vibrations_alone(modes, with)) {
        ++halvings;
        with.control.time_step /= 2;
    }
    return halvings;
}

double work_worth_the_modes(const Model& model, const std::vector<Stage>& stages)
{
    double steps = 0;
    for (const Stage& stage : stages) {
        const double step = stage.control.automatic ? step_of_unknown_modes : stage.control.time_step;
        if (stage.type == StageType::dynamic) steps += std::ceil(stage.duration / step);
    }
    const double blocks = static_cast<double>(model.blocks.size());
    return std::max(always_allowed, share_of_the_run * steps * blocks * work_of_a_block_in_a_step);
}

}  // namespace voussoir
