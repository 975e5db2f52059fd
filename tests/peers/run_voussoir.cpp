#include "app/studies/scenes/stages.h"
#include "app/words/diagnosis_words.h"
#include "libdda/run/run.h"
#include "tests/peers/engines.h"

namespace voussoir::peers
{
namespace
{

std::vector<Stage> stages_of(const Scene& scene, const Setting& setting)
{
    Stage motion = app::studies::scenes::motion_stage(scene.duration, setting.time_step, scene.gravity);
    for (int axis = 0; axis < 2; ++axis)
        for (std::size_t block = 0; block < scene.bodies.size() && scene.push[axis]; ++block)
            if (!scene.bodies[block].held)
                motion.body_accelerations.push_back({static_cast<int>(block), axis, scene.push[axis]});
    if (scene.rest == 0) return {motion};
    return {app::studies::scenes::rest_stage(scene.gravity), motion};
}

}  // namespace

std::string run_voussoir(const Scene& scene, const Setting& setting, const Watch& watch)
{
    const std::vector<Stage> stages = stages_of(scene, setting);
    const int last = static_cast<int>(stages.size()) - 1;
    State state = initial_state(scene.model);
    bool goes_on = true, begun = false;
    const auto show = [&](const State& now, double time) {
        goes_on = watch(time, [&](int block) -> Place {
            const Pose pose = pose_of(scene.model.kinematics, now, block);
            return {pose.centroid, pose.map};
        });
    };
    RunObserver observer;
    State rest = state;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        if (now.stage < last) {
            rest = now;
            return;
        }
        if (!begun) show(rest, 0);
        begun = true;
        if (goes_on) show(now, now.stage_time);
    };
    observer.stop = [&] { return !goes_on; };
    const RunReport report = run(scene.model, stages, state, observer);
    const bool ended = !goes_on || report.outcome != Outcome::gave_up;
    return ended ? "" : app::words::message_of(report, scene.model, stages);
}

}  // namespace voussoir::peers
