// What must hold of every case that is accepted, whatever the file: asked by the fuzzer and by the test of damaged
// cases.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "app/reader/case_file.h"

namespace voussoir
{

inline void require_of_case(bool holds, const std::string& what)
{
    if (!holds) throw std::logic_error("an accepted case " + what);
}

inline void check_accepted_model(const Model& model)
{
    const auto has = [](int index, std::size_t count) { return index >= 0 && index < static_cast<int>(count); };
    require_of_case(!model.blocks.empty(), "has no block");
    require_of_case(model.origin.allFinite(), "lies nowhere");
    require_of_case(model.joint_of_groups.size() == model.groups.size() * model.groups.size(),
                    "has no joint for some pair of groups");
    for (const int joint : model.joint_of_groups)
        require_of_case(has(joint, model.joints.size()), "names a joint that is not there");
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        const Block& block = model.blocks[b];
        require_of_case(has(block.group, model.groups.size()), "has a block of no group");
        require_of_case(has(block.material, model.materials.size()), "has a block of no material");
        require_of_case(is_planar(model.kinematics) ? !block.outlines.empty() : !block.parts.empty(),
                        "has a block without shape");
        require_of_case(block.moments.volume > 0 && std::isfinite(model.mass(static_cast<int>(b))),
                        "has a block without volume or mass");
        require_of_case(block.moments.centroid.allFinite() && block.moments.second.allFinite(),
                        "has a block that lies nowhere");
    }
    for (const Foundation& foundation : model.foundations)
        require_of_case(has(foundation.block, model.blocks.size()), "has a foundation without block");
    for (const Bar& bar : model.bars) {
        require_of_case(has(bar.block_a, model.blocks.size()) && has(bar.block_b, model.blocks.size()) &&
                            bar.block_a != bar.block_b,
                        "has a bar without two blocks");
        require_of_case(std::isfinite(bar.axial) && std::isfinite(bar.lateral) && bar.axial + bar.lateral > 0,
                        "has a bar without stiffness");
        require_of_case(bar.anchor_a.allFinite() && bar.anchor_b.allFinite() && std::isfinite(bar.length) &&
                            std::isfinite(bar.prestress) && std::abs(bar.axis.norm() - 1) < 1e-9,
                        "has a bar that lies nowhere");
    }
}

inline void check_accepted_stage(const Stage& stage)
{
    const bool is_dynamic = stage.type == StageType::dynamic;
    const double steps = stage.duration / stage.control.time_step;
    require_of_case(stage.control.time_step > 0 && std::isfinite(stage.control.time_step), "has no time step");
    require_of_case(stage.gravity.allFinite(), "has no finite gravity");
    require_of_case(!is_dynamic || (stage.duration > 0 && steps <= 1e10), "never ends");
    for (const FoundationMotion& motion : stage.motions)
        require_of_case(motion.motion && std::isfinite(motion.motion->displacement(stage.duration / 3)),
                        "moves the ground to infinity");
}

/// @throws std::logic_error that says what does not hold
inline void check_accepted(const app::Case& the_case)
{
    check_accepted_model(the_case.model);
    require_of_case(!the_case.stages.empty(), "has no stage");
    for (const Stage& stage : the_case.stages) check_accepted_stage(stage);
    require_of_case(the_case.output.every > 0 && std::isfinite(the_case.output.every), "never shows a frame");
    for (const app::HistoryPoint& history : the_case.output.histories)
        require_of_case(!history.point || history.point->allFinite(), "follows a point that is nowhere");
    for (const app::BarHistory& history : the_case.output.bar_histories)
        require_of_case(history.bar >= 0 && history.bar < static_cast<int>(the_case.model.bars.size()),
                        "follows a bar that is not there");
}

}  // namespace voussoir
