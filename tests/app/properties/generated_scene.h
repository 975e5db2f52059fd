// Cases made at random from a seed, and the ways in which the same case can be told.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace voussoir::app::properties
{

struct Box {
    std::string name;
    Eigen::Vector3d lower, upper;  // m
};

/// A held floor and stacks of boxes on it, one of which may be thrown; a floor that shakes; one or two stages.
struct GeneratedScene {
    std::vector<Box> boxes;  // the floor first; then from the floor up, stack by stack
    bool flat = false;       // all of one extent along y: it can be told as a planar scene
    bool deformable = false;
    double friction = 0;                                 // deg
    double young = 0;                                    // Pa
    double shaking = 0;                                  // m/s2, of a sine along x
    double frequency = 0;                                // Hz
    double lifting = 0;                                  // m/s2, of a sine along z
    bool settles = false;                                // a static stage comes first
    std::string thrown;                                  // a box on top of its stack; empty: none
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // m/s, of it
};

GeneratedScene generated(std::uint64_t seed);

/// How a scene is told. Coordinates x are told as scale R x + offset, where R may mirror.
struct Telling {
    int quarter_turns = 0;                             // about z
    bool mirrored = false;                             // x -> -x, before the turn
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();  // m
    double scale = 1;          // units of length per metre: all else is told in these units, too
    std::string unit = "m";    // that lengths are written in; the same case
    bool other_order = false;  // stacks in another order
    std::string kinematics;    // empty: spatial, rigid or deformable as the scene says
    double young = 0;          // Pa, instead of the scene's; 0: the scene's
    std::string joint;         // further keys of the joint: "contact_stiffness: 1 GPa/m"

    Eigen::Matrix3d rotation() const;
};

/// The case file.
std::string text_of(const GeneratedScene& scene, const Telling& telling);

/// A number of the text replaced by another, a key misspelt, a line lost or doubled: what people and machines do
/// to files. The same for the same seed.
std::string mutated(std::string text, std::uint64_t seed);

}  // namespace voussoir::app::properties
