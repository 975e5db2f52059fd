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
    explicit Workspace(const Model& model);
    ~Workspace();
    Workspace(Workspace&&) noexcept;
    Workspace& operator=(Workspace&&) noexcept;

    struct Implementation;  // per kinematics: step/work.h
    std::unique_ptr<Implementation> implementation;
};

}  // namespace voussoir
