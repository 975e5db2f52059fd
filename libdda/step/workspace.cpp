#include "libdda/step/workspace.h"

#include "libdda/step/work.h"

namespace voussoir
{

Workspace::Workspace(const Model& model) : implementation(std::make_unique<Implementation>())
{
    switch (model.kinematics) {
        case Kinematics::spatial_deformable:
            break;  // the variant's first
        case Kinematics::spatial_rigid:
            implementation->work.emplace<Work<step::SpatialRigid>>();
            break;
        case Kinematics::planar_deformable:
            implementation->work.emplace<Work<step::PlanarDeformable>>();
            break;
        case Kinematics::planar_rigid:
            implementation->work.emplace<Work<step::PlanarRigid>>();
            break;
    }
}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

}  // namespace voussoir
