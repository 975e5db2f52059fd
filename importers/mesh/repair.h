// What was changed on the way from a file to a stone.
#pragma once

#include <string>

namespace voussoir::importers::mesh
{

/// One repair of a stone or of a file. Repairs of one kind are summed up in one line of print, so that a kind is
/// the same few words for all of them.
struct Repair {
    std::string kind;       // "vertices welded"; empty: like no other, never summed up
    std::string text;       // a sentence of its own, with numbers
    int count = 1;          // how often
    std::string counted{};  // what is counted, "vertices"; empty: nothing worth telling
    double worst = 0;       // the largest of it, in `unit`; 0: has no size
    std::string unit{};     // "m", "m3", "%"
};

}  // namespace voussoir::importers::mesh
