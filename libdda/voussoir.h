// The engine for programs that embed it: what is included here, and what that includes, is installed and nothing
// else. docs/embedding.md, docs/examples/embed.
#pragma once

#include <Eigen/Core>

#include "libdda/analysis/joint_resultants.h"
#include "libdda/analysis/joints_now.h"
#include "libdda/errors.h"
#include "libdda/instruction_set.h"
#include "libdda/run/run.h"
#include "libdda/step/advance.h"

// The library and those who use it must lay out Eigen's types alike: CMake's target voussoir::dda defines both.
static_assert(EIGEN_MAX_ALIGN_BYTES == 32 && EIGEN_MAX_STATIC_ALIGN_BYTES == 32,
              "compile with -DEIGEN_MAX_ALIGN_BYTES=32 -DEIGEN_MAX_STATIC_ALIGN_BYTES=32, as voussoir was");
