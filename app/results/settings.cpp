#include "app/results/settings.h"

#include <nlohmann/json.hpp>

#include "app/results/scene_vectors.h"

namespace voussoir::app::results
{

std::string_view name_of(Integrator integrator)
{
    return integrator == Integrator::newmark ? "newmark" : "energy_decaying";
}

std::string_view name_of(OpenClose open_close)
{
    switch (open_close) {
        case OpenClose::newton:
            return "newton";
        case OpenClose::plain:
            return "plain";
        case OpenClose::published:
            return "published";
    }
    return "none";
}

std::string_view name_of(LinearSolverKind solver)
{
    switch (solver) {
        case LinearSolverKind::automatic:
            return "automatic";
        case LinearSolverKind::cholmod:
            return "cholmod";
        case LinearSolverKind::conjugate_gradients:
            return "conjugate_gradients";
    }
    return "none";
}

std::string_view name_of(StageType type)
{
    return type == StageType::dynamic ? "dynamic" : "static";
}

std::string_view name_of(ContactStiffness::Kind kind)
{
    switch (kind) {
        case ContactStiffness::Kind::from_modulus:
            return "from_modulus";
        case ContactStiffness::Kind::per_area:
            return "per_area_Pa_m";
        case ContactStiffness::Kind::per_point:
            return "per_point_N_m";
    }
    return "none";
}

std::string_view name_of(FaceLaw face)
{
    switch (face) {
        case FaceLaw::corners:
            return "corners";
        case FaceLaw::points:
            return "points";
        case FaceLaw::linear:
            return "linear";
    }
    return "";
}

std::string_view name_of(PlaneCondition plane)
{
    return plane == PlaneCondition::strain ? "strain" : "stress";
}

std::string_view name_of(RestSupport support)
{
    switch (support) {
        case RestSupport::full:
            return "full";
        case RestSupport::normal:
            return "normal";
        case RestSupport::none:
            break;
    }
    return "none";
}

namespace
{

using Json = nlohmann::ordered_json;

Json to_json(const StepControl& control)
{
    return {{"time_step_s", control.time_step},
            {"automatic_time_step", control.automatic},
            {"min_time_step_s", control.min_time_step},
            {"step_error_m", control.step_error},
            {"integrator", name_of(control.integrator)},
            {"dissipation", control.dissipation_used()},
            {"divide_up_to_blocks", control.divide_up_to_blocks},
            {"open_close", name_of(control.open_close)},
            {"max_open_close", control.max_open_close},
            {"force_tolerance", control.force_tolerance},
            {"linear_solver", name_of(control.linear_solver)},
            {"linear_tolerance", control.linear_tolerance}};
}

Json to_json(const Stage& stage, Kinematics kinematics)
{
    Json json = {{"name", stage.name},
                 {"type", name_of(stage.type)},
                 {"moves", stage.moves()},
                 {"gravity_m_s2", stored_vector(stage.gravity, kinematics)},
                 {"damping_rate_1_s", stage.damping.rate},
                 {"damping_factor_per_step", stage.damping.factor_per_step}};
    if (stage.type == StageType::dynamic) {
        json["duration_s"] = stage.duration;
        if (stage.gravity_ramp.duration > 0)
            json["gravity_ramp"] = {{"duration_s", stage.gravity_ramp.duration},
                                    {"from_m_s2", stored_vector(stage.gravity_ramp.from, kinematics)},
                                    {"turns", stage.gravity_ramp.turns}};
    } else {
        json["unbalanced_tolerance"] = stage.unbalanced_tolerance;
        json["max_static_steps"] = stage.max_static_steps;
        json["gravity_increments"] = stage.gravity_increments;
    }
    json["control"] = to_json(stage.control);
    return json;
}

}  // namespace

std::string settings_json(const std::vector<Stage>& stages, Kinematics kinematics)
{
    Json list = Json::array();
    for (const Stage& stage : stages) list.push_back(to_json(stage, kinematics));
    return list.dump(2);
}

}  // namespace voussoir::app::results
