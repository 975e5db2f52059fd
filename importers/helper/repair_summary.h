// Repairs of many stones in a few lines.
#pragma once

#include <string>
#include <vector>

#include "importers/helper/geometry.h"

namespace voussoir::importers::helper
{

/// All repairs of one kind in a file.
struct RepairSummary {
    std::string kind;         // of mesh::Repair; empty: one repair like no other
    int stones = 0;           // that were repaired; 0: the file was
    int repairs = 0;          // of this kind
    int count = 0;            // in all, of `counted`
    std::string counted;      // "vertices"
    double worst = 0;         // the largest, in `unit`; 0: has no size
    std::string unit;         // of `worst`
    std::string worst_stone;  // that has it; the first one where there is no size
    std::string text;         // the sentence of that repair
};

/// Repairs of the file first, then of its stones, each kind in the place of its first one.
std::vector<RepairSummary> summarised_repairs(const ImportedMesh& mesh);

/// "vertices welded: 12 stones, 36 vertices, at most 1.2e-07 m (arch.3)"; the sentence of the repair itself, after
/// the name of its stone, where there is only one.
std::string in_words(const RepairSummary& summary);

/// A number of a sentence, with three digits.
std::string short_number(double value);

/// What fitting joints came to: "joints: 285 did not fit as drawn, by up to 0.039 m, and were fitted"; what was
/// left. Nothing where all joints fit.
std::vector<std::string> in_words(const JointFit& fit);

/// "3 stones were left out (skip): a, b, c": a line for each of the keys that said so; those that were left out
/// because they would have been refused are one line.
std::vector<std::string> skipped_in_words(const ImportedMesh& mesh);

/// Every repair of a file in full, and every stone that was left out: "arch.3: 2 vertices up to ...".
std::vector<std::string> all_repairs(const ImportedMesh& mesh);

}  // namespace voussoir::importers::helper
