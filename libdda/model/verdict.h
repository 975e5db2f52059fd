// What has become of a structure at the end of a run.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace voussoir
{

/// Whether a structure stands.
enum class Standing {
    stands,       // all stones that the ground carried it still carries, and none moves
    moves,        // the same, but stones move on: how it ends is not known
    lost_stones,  // less than half of it, by mass, has come off or turned over
    fallen,       // half and more
};
/// The name, as in results.
std::string_view name_of(Standing standing);

/// How far joints are left open or slid, as a share of the size of their smaller stone: the residual dislocations
/// of drums [PsycharisFragiadakisStefanou2013], whose levels these are.
enum class DamageLevel { none, limited_deformation, light_damage, significant_damage };
/// The name, as in results.
std::string_view name_of(DamageLevel damage);

constexpr double limited_deformation = 0.005, light_damage = 0.01, significant_damage = 0.02;  // shares
constexpr double overturning_tilt = 0.5235987755982988;  // rad, 30 degrees: what leans more has turned over
constexpr double slow_end = 0.02;  // of sqrt(g size), the speed of a stone that has come to rest

/// How far a block is from where it was when the first motion began, relative to the ground.
struct BlockEnd {
    double displacement = 0;  // m, of the centroid
    double turn = 0;          // rad
};

/// A joint that is left open or slid.
struct Dislocation {
    int block_a = -1, block_b = -1;  // a < b; -1: no joint is
    double opening = 0, slip = 0;    // m, since the first motion began
    double share = 0;                // -, the larger of the two over the size of the smaller stone
};

/// Of a run that went to its end.
struct Verdict {
    Standing standing = Standing::stands;
    std::vector<int> lost;         // blocks that the ground carried when the run began and does no more, ascending
    double mass = 0;               // kg, that the ground carried then, soil left out
    double lost_share = 0;         // -, of that mass
    int fastest = -1;              // block, of those that are not lost; -1: none moves
    double speed = 0;              // m/s, of its fastest point relative to the ground
    double go_on = 0;              // s, for which a run should go on where something moves
    std::vector<BlockEnd> blocks;  // in the order of Model::blocks; of foundations too
    DamageLevel damage = DamageLevel::none;  // of a structure that stands
    Dislocation worst;                       // of joints between stones that are not lost
};

}  // namespace voussoir
