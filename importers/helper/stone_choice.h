// Which stones of a mesh file are taken, and how.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace voussoir::importers::helper
{

/// What becomes of a stone that cannot be certified.
enum class RepairRule { refuse, hull, skip };

/// The names above, in their order.
extern const std::vector<std::string> repair_rule_names;

/// Stones by patterns of their names, in which * stands for any letters and ? for one.
struct StoneChoice {
    std::vector<std::string> skip{};        // are left out, without being looked at
    std::vector<std::string> only{};        // all others are left out; empty: none is
    std::vector<std::string> hull{};        // are replaced by their convex hulls
    std::vector<std::string> skip_types{};  // of items of a building model (IFC) that are left out: "IfcWindow"
    RepairRule repair = RepairRule::refuse;
};

/// Stones of scans with fewer faces.
struct StoneSimplification {
    std::vector<std::string> stones{};  // patterns; empty: all
    bool hull = false;                  // their convex hulls
    int parts = 0;                      // convex parts at most; 0: does not say
    double volume_error = 0;            // share of the volume; 0: does not say
    int triangles = 0;                  // of the surface, before anything else; 0: all
    bool is_asked() const { return hull || parts > 0 || volume_error > 0 || triangles > 0; }
};

/// A stone that was left out.
struct SkippedStone {
    std::string name;
    std::string why;  // "skip", "only", "skip_types", or the reason for which it would have been refused
};

/// A pattern that no stone has the name of.
struct UnmatchedPattern {
    std::string key, pattern;  // "skip", "keystone*"
};

/// Does a name match a pattern in which * stands for any letters and ? for one?
bool matches_pattern(std::string_view name, std::string_view pattern);

}  // namespace voussoir::importers::helper
