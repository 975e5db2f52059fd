// Scenes of rigid blocks as every engine can be given them.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libdda/model/ground_motion.h"
#include "libdda/model/model.h"

namespace voussoir::peers
{

/// A stone, or what it stands on. `model.blocks` of Scene has shape and moments under the same index.
struct Body {
    bool held = false;
    bool is_box = true;                              // along the axes
    Eigen::Vector3d half = Eigen::Vector3d::Zero();  // m, of a box
};

/// Blocks at rest under their weight that are then pushed sideways, each by its mass times a(t).
struct Scene {
    Model model;               // as voussoir takes it; the others take shapes, masses and friction
    std::vector<Body> bodies;  // one for each block
    double friction = 0;       // -, coefficient
    bool slides = false;       // what slides does so at metres per second
    double gravity = 0;        // m/s2
    double rest = 0;           // s: so long engines without a static stage come to rest; 0: nobody does
    double duration = 0;       // s, of the motion
    std::shared_ptr<const GroundMotion> push[2];  // along x and y; none: nothing pushes
};

/// A flat block of 3 x 3 x 0.3 m that slides to and fro, pushed by minus the acceleration of a foundation that
/// moves by amplitude (1 - cos 2 pi f t) along x and, with `across`, along y. Source: [YagodaBiranHatzor2017],
/// section 3.4.2
Scene sliding_block(bool across);

/// The amplitudes [m] and frequencies [Hz] of that foundation along x and y.
struct FoundationWave {
    double amplitude = 0, frequency = 1;
};
std::vector<FoundationWave> foundation_waves(bool across);

constexpr double rocking_amplitude = 5.43, rocking_frequency = 1;      // m/s2, Hz, of half a sine
constexpr double rocking_half_width = 0.2, rocking_half_height = 0.6;  // m

/// A block that half a sine makes rock. @param duration [s]
Scene rocking_block(double duration);

/// The wall of tests/running_bond_wall.h, pushed in its plane by 0.3 g at 2 Hz for 2 s.
Scene shaken_wall(int courses, int blocks);

constexpr double arch_radius = 5;  // m, mean

/// A semicircular arch of 27 voussoirs on held supports, whose weight is suddenly there. @param share thickness /
/// radius
Scene semicircular_arch(double share);

}  // namespace voussoir::peers
