// The choice of stones of a mesh file, applied.
#pragma once

#include <string>
#include <vector>

#include "importers/helper/geometry.h"

namespace voussoir::importers::helper
{

/// Applies the patterns of a request, and keeps account of those that were never used. A stone goes by its own
/// name and by that of the surface it was separated from.
class StoneChooser
{
 public:
    explicit StoneChooser(const MeshRequest& request);

    /// Why a stone is left out: the key that says so; empty when it is taken.
    std::string left_out(const std::string& name, const std::string& surface);
    /// A whole surface that is left out with all stones in it.
    std::string left_out(const std::string& surface);
    bool wants_hull(const std::string& name, const std::string& surface);
    bool wants_simplification(const std::string& name, const std::string& surface);

    /// Patterns that matched nothing.
    std::vector<UnmatchedPattern> unmatched() const;

 private:
    struct Pattern {
        std::string key, pattern;
        bool used = false;
    };
    bool matches(const std::string& key, const std::string& name, const std::string& surface);

    std::vector<Pattern> patterns_;
    bool has_only_ = false, simplifies_ = false, simplifies_all_ = false;
};

}  // namespace voussoir::importers::helper
