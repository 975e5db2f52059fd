// Patterns read from ten lines of a case, and what holds for every one of them.
#pragma once

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "app/case/case.h"
#include "importers/assembly/assembly.h"
#include "libdda/model/report.h"
#include "libdda/run/run.h"
#include "tests/app/reader/case_reading.h"

namespace voussoir::app::patterns_test
{

/// A case with these lines as its only entry of blocks: at rest under its weight, then left alone for 10 s.
inline std::string pattern_case(const std::string& entry, double friction = 40, double wait = 10,
                                double step = 0.01)
{
    return "materials: {stone: {density: 2400 kg/m3, young: 5 GPa, poisson: 0.2}}\njoints: {dry: {friction: " +
           std::to_string(friction) + " deg}}\nblocks:\n  - " + entry +
           "\nfoundation: {blocks: foundation}\nstages:\n  - {name: self-weight, type: static}\n" +
           "  - {name: rest, type: dynamic, duration: " + std::to_string(wait) +
           " s, time_step: " + std::to_string(step) + " s}\n";
}

inline Case read_pattern(const std::string& entry, const std::vector<std::string>& overrides = {})
{
    return reader::read(pattern_case(entry), overrides);
}

inline int number_of(const Model& model, const std::string& name)
{
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
        if (model.blocks[b].name == name) return static_cast<int>(b);
    ADD_FAILURE() << "no block " << name;
    return 0;
}

inline const Block& block_of(const Model& model, const std::string& name)
{
    return model.blocks[static_cast<std::size_t>(number_of(model, name))];
}

inline std::string group_of(const Model& model, const std::string& name)
{
    return model.groups[static_cast<std::size_t>(block_of(model, name).group)];
}

inline int count_in(const Model& model, const std::string& group)
{
    int count = 0;
    for (const Block& block : model.blocks) count += model.groups[block.group] == group;
    return count;
}

/// Volume of a group's blocks, of all for "" [m3].
inline double volume_in(const Model& model, const std::string& group)
{
    double volume = 0;
    for (const Block& block : model.blocks)
        if (group.empty() || model.groups[block.group] == group) volume += block.moments.volume;
    return volume;
}

/// The certificate of a model, by the code that certifies meshes.
importers::assembly::Assembly assembly_of(const Model& model);

/// Area in which two blocks touch [m2]; 0 if they do not.
double joint_area(const importers::assembly::Assembly& assembly, const std::string& a, const std::string& b);

/// Nothing overlaps, floats, lacks support, gapes or is a sliver; all of it is one structure.
void expect_sound(const importers::assembly::Assembly& assembly);

/// Every block has a twin mirrored in the plane through the origin normal to `axis`: same volume, mirrored
/// centroid.
void expect_symmetric(const Model& model, int axis, double tolerance = 1e-8);

/// A run of all stages of a case.
struct Rest {
    RunReport report;
    double drift = 0;           // m, greatest motion of a centroid after the static stage
    double settlement = 0;      // m, in the static stage
    double reaction_error = 0;  // |force of the ground - weight| / weight, at the end of the static stage
};
Rest run_to_rest(const Case& the_case);

/// Stands, and drifts by less than 1e-6 m in the time that the case waits.
void expect_rest(const Case& the_case);

}  // namespace voussoir::app::patterns_test
