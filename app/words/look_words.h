// Views and cuts of pictures, as command lines and case files spell them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace voussoir::app::words
{

/// From where a structure is seen.
struct ViewAngles {
    double azimuth = 0;    // rad, of the viewer about z; 0: looks along y, x to the right
    double elevation = 0;  // rad, of the viewer above the ground
};

/// "front", "right", "back", "left", "top", or "AZIMUTH,ELEVATION" in degrees; nothing when it is none of these.
std::optional<ViewAngles> view_named(const std::string& words);
extern const char* const view_expected;  // what to give instead

/// A half space of stones that are left out.
struct Cut {
    int axis = 0;
    bool above = false;  // else below
    double place = 0;    // m
    /// @param centroid [m]
    bool takes(const Eigen::Vector3d& centroid) const
    {
        return above ? centroid[axis] > place : centroid[axis] < place;
    }
};

/// "x>1.5"; nothing when it is no cut.
std::optional<Cut> cut_named(const std::string& words);
extern const char* const cut_expected;  // what to give instead

/// The word that means all stones but the foundations where a picture follows something.
extern const char* const whole_structure;

}  // namespace voussoir::app::words
