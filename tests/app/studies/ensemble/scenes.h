// Small cases for ensembles.
#pragma once

#include <string>

namespace voussoir::testing
{

/// A block of 1 m3 on a joint of 5 MPa/m (a linear oscillator of 7.3 Hz) that a wave on the block shakes.
inline std::string shaken_stone(const std::string& wave, const std::string& time_step)
{
    return R"(title: A shaken stone
kinematics: spatial_rigid
materials: {stone: {density: 2400 kg/m3, young: 10 GPa, poisson: 0.2}}
joints: {soft: {friction: 30 deg, contact_stiffness: 5 MPa/m}}
blocks:
  - {box: {name: floor, lower: [-1, -1, -1], upper: [1, 1, 0]}, group: foundation}
  - {box: {name: stone, lower: [-0.5, -0.5, 0], upper: [0.5, 0.5, 1]}}
foundation: {blocks: foundation}
stages:
  - {name: rest, type: static}
  - name: shaking
    type: dynamic
    duration: 0.32 s
    time_step: )" +
           time_step + R"(
    body_acceleration: [{blocks: masonry, )" +
           wave + R"(}]
output: {every: 1 ms, histories: {top: {block: stone}}}
)";
}

/// Stays pressed.
inline const std::string gentle_wave = "z: {sine: {acceleration: 2 m/s2, frequency: 3 Hz}}";

/// Lifts the block: downwards at first, then up by more than gravity.
inline const std::string lifting_wave = "z: {sine: {acceleration: 30 m/s2, frequency: 5 Hz, duration: 0.1 s}}";

inline const std::string vary_friction = "joints.soft.friction=29 deg,30 deg,31 deg";

}  // namespace voussoir::testing
