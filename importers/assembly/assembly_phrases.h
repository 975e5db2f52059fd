// The phrases that findings about an assembly are made of.
#pragma once

#include <algorithm>

#include "importers/assembly/assembly.h"

namespace voussoir::importers::assembly
{

/// "1 pair", "3 pairs".
std::string plural(std::size_t count, const std::string& word);

/// The verb of a count: "touches" of one, "touch" of more.
const char* verb(std::size_t count, const char* of_one, const char* of_more);

/// "a, b, c, d and 12 more".
std::string names_of(const Assembly& assembly, const std::vector<int>& stones);

/// "a and b".
std::string pair_words(const Assembly& assembly, int a, int b);

/// The option or the key that closes gaps up to `widest` [m].
std::string close_joints_words(double widest, const AssemblyOrigin& origin);

// Findings about pairs of stones, in a file of their own.
void tell_overlaps(const Assembly& assembly, std::vector<AssemblyFinding>& findings);
void tell_gaps(const Assembly& assembly, const AssemblyOrigin& origin, std::vector<AssemblyFinding>& findings);
void tell_poor_contacts(const Assembly& assembly, const AssemblyOrigin& origin,
                        std::vector<AssemblyFinding>& findings);

/// Whether a stone begins turned or moving.
bool begins_apart(const Assembly& assembly, const AssemblyOrigin& origin, int stone);

}  // namespace voussoir::importers::assembly
