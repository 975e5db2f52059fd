#include "app/results/units.h"

#include <algorithm>
#include <array>
#include <utility>

namespace voussoir::app::results
{

std::string_view unit_of(std::string_view dataset)
{
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 48> units = {{
        {"/model/origin", "m"},
        {"/model/volume", "m3"},
        {"/model/mass", "kg"},
        {"/model/friction_factor", "1"},
        {"/model/centroid", "m"},
        {"/model/second_moments", "m5"},
        {"/model/materials/density", "kg/m3"},
        {"/model/materials/young", "Pa"},
        {"/model/materials/poisson", "1"},
        {"/model/joint_materials/friction_angle", "rad"},
        {"/model/joint_materials/cohesion", "Pa"},
        {"/model/joint_materials/tensile_strength", "Pa"},
        {"/model/joint_materials/dashpot", "s"},
        {"/model/mesh/levers", "m"},
        {"/frames/time", "s"},
        {"/frames/coordinates", "m; then 1, of angles rad"},
        {"/frames/velocities", "m/s; then 1/s, of angular velocities rad/s"},
        {"/frames/stress", "Pa"},
        {"/frames/ground_displacement", "m"},
        {"/frames/positions", "m"},
        {"/frames/face_displacement", "m"},
        {"/frames/face_least_stress", "Pa"},
        {"/frames/face_greatest_stress", "Pa"},
        {"/frames/energy", "J"},
        {"/joints/area", "m2"},
        {"/joints/facing_area", "m2"},
        {"/joints/centre", "m"},
        {"/joints/normal", "1"},
        {"/joints/largest_opening", "m"},
        {"/joints/largest_slip", "m"},
        {"/joints/opened_time", "s"},
        {"/joints/slid_time", "s"},
        {"/frames/joints/opening", "m"},
        {"/frames/joints/mean_opening", "m"},
        {"/frames/joints/slip", "m"},
        {"/frames/joints/largest_slip", "m"},
        {"/frames/joints/normal_force", "N"},
        {"/frames/joints/shear_force", "N"},
        {"/frames/joints/eccentricity", "m"},
        {"/frames/joints/area_in_use", "m2"},
        {"/frames/contacts/force", "N"},
        {"/frames/contacts/moment", "N m"},
        {"/frames/contacts/centre", "m"},
        {"/frames/contacts/pressure_centre", "m"},
        {"/frames/contacts/normal", "1"},
        {"/frames/contacts/normal_force", "N"},
        {"/frames/contacts/area", "m2"},
        {"/frames/contacts/closed_area", "m2"},
    }};
    const auto found =
        std::find_if(units.begin(), units.end(), [&](const auto& one) { return one.first == dataset; });
    return found != units.end() ? found->second : std::string_view();
}

}  // namespace voussoir::app::results
