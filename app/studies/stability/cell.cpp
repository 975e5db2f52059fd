#include "app/studies/stability/cell.h"

#include <fmt/format.h>

#include <cmath>

#include "app/studies/stability/families.h"

namespace voussoir::app::studies::stability
{

std::vector<StabilityScene> stability_scenes(const CaseReader& read)
{
    return {sliding_scene(), rocking_scene(), step_error_scene(), wall_scene(),     modulus_scene(),
            column_scene(),  density_scene(), size_scene(),       shape_scene(),    needle_scene(),
            point_scene(),   face_scene(),    fit_scene(),        friction_scene(), coordinate_scene(read),
            gravity_scene(), shaking_scene(), impact_scene(),     uplift_scene(),   landing_scene(),
            ground_scene(),  bar_scene(),     verdict_scene(),    many_scene(),     heap_scene()};
}

std::string in_words(const CellParameter& parameter)
{
    if (std::isinf(parameter.value)) return "rigid";
    return fmt::format("{:.4g}{}{}", parameter.value, parameter.unit.empty() ? "" : " ", parameter.unit);
}

}  // namespace voussoir::app::studies::stability
