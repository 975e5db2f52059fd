// The small scenes whose last bits stand for what the engine does.
//
// They share nothing with the scenes of tests and studies, which may change: a golden scene may not, for then the
// hashes move though the engine has not.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"

namespace voussoir::app::golden
{

/// A scene ready to run.
struct Scene {
    Model model;
    std::vector<Stage> stages;
    State state;  // to begin with
};

struct NamedScene {
    std::string name;  // "column, planar rigid"
    std::function<Scene()> make;
};

/// All of them. Together they slide, rock, knock, tumble, stick, break, are crushed, turn round, are cut and fall,
/// in each kind of unknowns, with each integrator, open-close iteration and linear solver.
std::vector<NamedScene> scenes();

}  // namespace voussoir::app::golden
