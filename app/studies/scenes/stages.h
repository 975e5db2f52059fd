// A scene and its stages: rest, then motion.
#pragma once

#include <vector>

#include "app/studies/scenes/scene_setting.h"
#include "libdda/model/model.h"
#include "libdda/model/stage.h"

namespace voussoir::app::studies::scenes
{

constexpr double papers_gravity = 9.81;  // m/s2, the papers'

/// A scene ready to run.
struct StagedScene {
    Model model;
    std::vector<Stage> stages;
};

/// Static equilibrium under gravity (0, 0, -g), all else by default.
Stage rest_stage(double g = papers_gravity);

/// Motion with no damping but the integrator's own, all else by default.
Stage motion_stage(double duration, double time_step, double g = papers_gravity);

/// The same with the integrator, the open-close iteration and the step of a setting.
Stage static_stage(const SceneSetting& setting, const Eigen::Vector3d& g = {0, 0, -papers_gravity});
Stage dynamic_stage(const SceneSetting& setting, double duration,
                    const Eigen::Vector3d& g = {0, 0, -papers_gravity});

}  // namespace voussoir::app::studies::scenes
