// Cases made at random from a seed, and the ways in which the same case can be told.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace voussoir::app::properties
{

struct Box {
    std::string name;
    Eigen::Vector3d lower, upper;  // m
};

/// A wall in running bond along x, its middle above the floor's origin; perhaps with a door.
struct GeneratedWall {
    double length = 0, height = 0, thickness = 0, block_length = 0, block_height = 0;  // m
    bool door = false;
};

/// A stone that grows narrower upwards, in a file of its own.
struct MeshStone {
    double middle = 0;           // m, along x
    Eigen::Vector2d foot, head;  // m, half its extents along x and y
    double height = 0;           // m
};

/// Metal between two boxes: a rod between their middles, or dowels in the joint of two that lie upon one another.
struct GeneratedBar {
    bool dowels = false;
    std::string from, to;  // boxes; of dowels groups with these boxes alone
    double diameter = 0;   // m
    double yield = 0;      // Pa; 0: elastic
    double prestress = 0;  // Pa, of rods
    double length = 0;     // m, of dowels
    std::string carries;
};

enum class Shaking { sine, ricker, pulse, record };

/// A held floor and stacks of boxes on it, one of which may be thrown, or a wall; perhaps a stone from a mesh file
/// beside them, or rods and dowels between the boxes; a floor that shakes; one to three stages.
struct GeneratedScene {
    std::vector<Box> boxes;  // the floor first; then from the floor up, stack by stack
    std::optional<GeneratedWall> wall;
    std::optional<MeshStone> mesh;
    std::vector<GeneratedBar> bars;
    bool flat = false;  // all of one extent along y: it can be told as a planar scene
    bool deformable = false;
    double friction = 0;                                 // deg
    double young = 0;                                    // Pa
    double shaking = 0;                                  // m/s2, along x
    Shaking kind = Shaking::sine;                        // of it
    double frequency = 0;                                // Hz
    double lifting = 0;                                  // m/s2, of a sine along z
    bool settles = false;                                // a static stage comes first
    bool goes_on = false;                                // a second dynamic stage, damped and in other steps
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

/// The files that it names, and what is in them.
std::map<std::string, std::string> files_of(const GeneratedScene& scene, const Telling& telling);

/// A number of the text replaced by another, a key misspelt, a line lost or doubled: what people and machines do
/// to files. The same for the same seed.
std::string mutated(std::string text, std::uint64_t seed);

}  // namespace voussoir::app::properties
