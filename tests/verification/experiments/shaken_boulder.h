// A granite boulder that stands free on a shake table: the measured motions of the table, whether it was
// overturned, and the same motions in the engine. Source: [ChenBoulder]
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libdda/geometry/moments.h"
#include "libdda/model/ground_motion.h"
#include "libdda/model/step_control.h"

namespace voussoir::verification
{

/// The boulder as a stone of twelve convex parts, its lowest point at z = 0 below the origin.
struct BoulderShape {
    std::vector<ConvexPolyhedron> parts;
    Moments moments;
};

/// One test on the table.
struct TableMotion {
    int number = 0;
    std::string record;
    bool overturned = false;
    double peak_velocity = 0;      // m/s, as listed: without slow motion
    double peak_acceleration = 0;  // g, as listed
    std::shared_ptr<const GroundMotion> motion;
};

/// What is not known of the boulder, and the numerics.
struct BoulderSetting {
    double friction = 0.6;                    // -
    double sign = 1;                          // of the motion, towards x of the mesh
    std::optional<double> restitution = 0;    // -; none: the springs alone
    double young = 5e10;                      // Pa: of granite; it sets the stiffness of contacts alone
    std::optional<double> stiffness;          // N/m per point; none: the default
    StepControl control = default_control();  // what a case file has unless it says otherwise

    static StepControl default_control()
    {
        StepControl control;
        control.time_step = 2e-3;
        return control;
    }
};

/// How a test ends in the engine.
struct BoulderEnd {
    bool settled = false;     // it came to rest before the shaking
    bool ran = false;         // to the end of the motion, or until it lay
    double largest_tilt = 0;  // degrees, against its rest before the shaking
    double last_tilt = 0;     // degrees; the run ends beyond 45
    double moved = 0;         // m, over the table, of the centroid
    double seconds = 0;       // of processor time
    bool overturned = false;  // by 45 degrees, or it rests on another face
};

/// Reads and simplifies the scan. @throws InputError when it cannot
BoulderShape read_boulder();

/// The tests; motions are cubic between their samples and stay where they end.
std::vector<TableMotion> read_table_motions();

BoulderEnd end_of(const BoulderShape& shape, const TableMotion& test, const BoulderSetting& setting);

/// Ends of tests, side by side.
std::vector<BoulderEnd> ends_of(const BoulderShape& shape, const std::vector<TableMotion>& tests,
                                const BoulderSetting& setting);

/// What a line of the table says.
struct BoulderFigures {
    int right = 0, false_overturnings = 0, misses = 0, stopped = 0, tests = 0;
    double accuracy() const { return tests > 0 ? static_cast<double>(right) / tests : 0; }
    /// Binomial standard error of the accuracy.
    double error() const { return tests > 0 ? std::sqrt(accuracy() * (1 - accuracy()) / tests) : 0; }
};
BoulderFigures figures_of(const std::vector<TableMotion>& tests, const std::vector<BoulderEnd>& ends);

/// The same of "it is overturned when the listed peak velocity exceeds `threshold`" [m/s].
BoulderFigures figures_of_threshold(const std::vector<TableMotion>& tests, double threshold);

}  // namespace voussoir::verification
