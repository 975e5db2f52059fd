// What a picture shows beside the stones, and from where: as asked for, and as it is of one run.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/render/camera.h"
#include "app/render/ground_shaking.h"
#include "app/results/results_reader.h"

namespace voussoir::app::render
{

struct Look {
    std::vector<std::string> hidden;  // patterns of names of stones, or of groups; * and ? stand for others
    std::vector<std::string> cuts;    // "x>1.5": stones whose centroid at the start is there are left out [m]
    std::vector<std::string> labels;  // patterns of names of stones that are written beside them
    std::optional<double> azimuth;    // rad, of the viewer about z; 0: looks along y, x to the right
    std::optional<double> elevation;  // rad, of the viewer above the ground
    std::string follow;               // pattern of stones or groups with which the camera goes; "structure": all
    bool orthographic = false;
    double orbit = 0;     // rad that the viewer turns about z in the course of a film
    bool forces = false;  // of the contacts, and the line of thrust
    bool ground = false;  // the acceleration of the ground, as an arrow
    bool groups = false;  // colours show the groups
};

/// "front", "right", "back", "left", "top", or "AZIMUTH,ELEVATION" in degrees. @throws InputError
void set_view(const std::string& text, Look& look);

/// The same for the stones of one run.
struct LookOfRun {
    std::vector<bool> hidden, labelled;    // (blocks); empty: none
    std::vector<std::string> group_names;  // empty: colours do not show groups
    std::vector<std::int32_t> group;       // (blocks)
    double largest_force = 0;              // N, of all contacts over the run; 0: forces are not drawn
    std::vector<double> followed;  // (blocks) weights, 1 together, of what the camera goes with; empty: nothing
    std::vector<GroundShaking> shaking;  // of the supports; empty: not drawn
};

/// @throws InputError for a pattern that no stone has, or a cut that is none
LookOfRun look_of(const Look& look, const std::filesystem::path& file, const results::ResultsReader& results);

/// Seen as the look says, or else as `usual`. @param points (n >= 1) [m]; @param orbited [rad]
Camera look_at(const std::vector<Eigen::Vector3d>& points, const PictureArea& area, double aspect, View usual,
               const Look& look, double orbited);

}  // namespace voussoir::app::render
