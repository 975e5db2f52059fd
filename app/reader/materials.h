// The parts of a case about stone and joints: `materials`, `joints`, `joint_rules`, `default_joint`.
#pragma once

#include <string>
#include <vector>

#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"

namespace voussoir::app::reader
{

std::vector<BlockMaterial> read_materials(YamlCursor& top, Kinematics kinematics);

/// `density` of a material: a density, or the weight per volume that engineers' tables give [kg/m3].
double read_density(YamlCursor& map);

/// `{ratio: 5 %, at: [1 Hz, 10 Hz]}`, or a ratio for each frequency: a / (2 omega) + b omega / 2 is what was asked
/// for at both.
RayleighDamping read_rayleigh(YamlCursor& map);

/// `{ratio: 5 %, band: [1 Hz, 10 Hz]}`: the same ratio at all frequencies of the band. Fills material.branches,
/// and makes material.young, which was given for the middle of the band, that at rest.
void read_hysteretic(YamlCursor& map, BlockMaterial& material);

std::vector<JointMaterial> read_joints(YamlCursor& top);

/// Which joint lies between which groups: `default_joint` (the only one, if there is one), then `joint_rules`.
/// @returns (groups x groups) row major, symmetric
std::vector<int> read_joint_rules(YamlCursor& top, const std::vector<JointMaterial>& joints,
                                  const std::vector<std::string>& groups);

}  // namespace voussoir::app::reader
