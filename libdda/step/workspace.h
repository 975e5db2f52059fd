// Scratch memory that lives from step to step.
#pragma once

#include <memory>

#include "libdda/model/model.h"

namespace voussoir
{

/// Nothing in it may change a result.
class Workspace
{
 public:
    /// @param model whose kinematics decide what is worked on
    explicit Workspace(const Model& model);
    ~Workspace();
    Workspace(Workspace&&) noexcept;             ///< Moved.
    Workspace& operator=(Workspace&&) noexcept;  ///< Moved.

    struct Implementation;  // per kinematics: step/work.h
    std::unique_ptr<Implementation> implementation;
};

}  // namespace voussoir
