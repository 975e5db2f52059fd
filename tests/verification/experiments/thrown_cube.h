// A plastic cube thrown on a table: the tracked tosses of ContactNets, and the same tosses in the engine.
// Source: [Pfrommer2020]
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libdda/model/step_control.h"

namespace voussoir::verification
{

constexpr double cube_edge = 0.1048;     // m
constexpr double cube_mass = 0.37;       // kg
constexpr double cube_inertia = 8.1e-4;  // kg m2, about each axis; a uniform cube would have 6.8e-4

/// Centre [m] and turn of the cube, body to world, row by row.
struct TrackedMotion {
    std::vector<double> times;  // s
    std::vector<Eigen::Vector3d> centres;
    std::vector<Eigen::Quaterniond> turns;
};

/// One toss as tracked, and how it starts.
struct Toss {
    int number = 0;
    TrackedMotion measured;
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // m/s, at row 0
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();      // rad/s, world axes, at row 0
};

/// What is not known of the cube, as published, and the numerics; all else is measured.
struct CubeSetting {
    double friction = 0.18;                     // -
    std::optional<double> restitution = 0.125;  // -; none: the springs alone
    double table = 0;                           // m, height of the table's top
    double young = 3e9;                         // Pa: of a plastic; it sets the stiffness of contacts alone
    std::optional<double> stiffness;            // N/m per point; none: the default
    StepControl control = default_control();    // what a case file has unless it says otherwise

    static StepControl default_control()
    {
        StepControl control;
        control.time_step = 2e-3;
        return control;
    }
};

/// How far a predicted toss is from the measured one.
struct TossScore {
    double position = 0;            // m, mean distance of the centres over all rows
    double rotation = 0;            // degrees, mean over all rows; the cube is marked
    bool right_face = false;        // the same face up at the end
    double travel = 0;              // m, distance of the horizontal displacements
    double measured_travel = 0;     // m, length of the horizontal displacement
    double predicted_travel = 0;    // m
    std::vector<double> distances;  // m, of the centres, row by row
    bool ran = false;               // to the end
};

/// Of a table. Velocities are taken to row 0: they are differences to the row before.
/// @throws InputError when it cannot be read
std::vector<Toss> read_tosses(const std::filesystem::path& file);

TrackedMotion predicted_toss(const Toss& toss, const CubeSetting& setting, bool& ran);

/// What predicts a toss, and says whether it ran to the end.
using CubeModel = std::function<TrackedMotion(const Toss&, const CubeSetting&, bool& ran)>;

/// Scores of tosses, side by side.
std::vector<TossScore> scores_of(const std::vector<Toss>& tosses, const CubeSetting& setting,
                                 const CubeModel& model = predicted_toss);

/// What a line of the table says of some tosses.
struct CubeFigures {
    double position = 0, position_low = 0, position_high = 0;  // m: median, quarter, three quarters
    double rotation = 0;                                       // degrees, median
    double right_faces = 0, right_faces_error = 0;             // share, and its binomial standard error
    double travel = 0, travel_bias = 0;                        // m, medians
    double mean_position = 0;                                  // m
    int stopped = 0;                                           // tosses that did not run to the end
};
CubeFigures figures_of(const std::vector<TossScore>& scores);

}  // namespace voussoir::verification
