#include "libdda/contact/normal_stiffness.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace voussoir::contact
{

namespace
{

constexpr double nearly_rigid = 300;  // E / L

/// Extent along the normal of the block that the part belongs to [m].
template <int D>
double depth_along(const Model& model, const PlacedPartIn<D>& part, const VectorIn<D>& normal)
{
    const std::size_t count = ShapeIn<D>::of(model.blocks[part.block]).size();
    double high = -INFINITY, low = INFINITY;
    for (const PlacedPartIn<D>& own : std::span(&part - part.part, count)) {
        high = std::max(high, own.support(normal));
        low = std::min(low, -own.support(-normal));
    }
    return high - low;
}

template <int D>
double stiffness_from_modulus(const Model& model, const std::vector<bool>& fully_held,
                              const PlacedPartIn<D>& first, const PlacedPartIn<D>& second,
                              const VectorIn<D>& normal)
{
    double compliance = 0;
    for (const PlacedPartIn<D>* part : {&first, &second}) {
        if (fully_held[part->block]) continue;
        const Block& block = model.blocks[part->block];
        compliance += depth_along(model, *part, normal) / model.materials[block.material].young;
    }
    const JointMaterial& joint = model.joint_between(first.block, second.block);
    return 2 * times_modulus(model.kinematics, joint) / compliance;
}

std::size_t corners_of(const PlacedPart& part, int face)
{
    return part.shape->faces[face].size();
}

std::size_t corners_of(const PlacedOutline&, int)
{
    return 2;
}

/// Shi's penalty per contact point, spread over the smaller of the two faces: value x corners / area.
/// @returns N/m per unit of measure (m2, planar m)
template <int D>
double stiffness_from_points(double value, const ContactPolygonIn<D>& polygon, const PlacedPartIn<D>& reference,
                             const PlacedPartIn<D>& incident)
{
    if (polygon.edge_edge) return value / polygon.points.front().area;
    const int f = static_cast<int>(polygon.reference_feature), g = static_cast<int>(polygon.incident_feature);
    const double of_reference = face_measure(reference, f), of_incident = face_measure(incident, g);
    const std::size_t corners = of_reference < of_incident ? corners_of(reference, f) : corners_of(incident, g);
    return value * static_cast<double>(corners) / std::min(of_reference, of_incident);
}

template <int D>
double stiffness_as_given(const Model& model, const std::vector<bool>& fully_held,
                          const ContactPolygonIn<D>& polygon, const PlacedPartIn<D>& reference,
                          const PlacedPartIn<D>& incident)
{
    const ContactStiffness& given = model.joint_between(reference.block, incident.block).stiffness;
    switch (given.kind) {
        case ContactStiffness::Kind::per_area:
            return given.value;
        case ContactStiffness::Kind::per_point:
            return stiffness_from_points(given.value, polygon, reference, incident) / depth_of<D>(model);
        case ContactStiffness::Kind::from_modulus:
            break;
    }
    return stiffness_from_modulus<D>(model, fully_held, reference, incident, polygon.normal);
}

}  // namespace

double default_stiffness_factor(Kinematics kinematics, const JointMaterial& joint)
{
    if (!is_deformable(kinematics)) return 10;
    return joint.has_strength() ? nearly_rigid : 30;
}

void stiffen_for_rest(Model& model)
{
    if (is_deformable(model.kinematics)) return;
    for (JointMaterial& joint : model.joints) {
        ContactStiffness& stiffness = joint.stiffness;
        if (stiffness.kind == ContactStiffness::Kind::from_modulus && stiffness.value == 0)
            stiffness.value = nearly_rigid;
    }
}

double times_modulus(Kinematics kinematics, const JointMaterial& joint)
{
    return joint.stiffness.value > 0 ? joint.stiffness.value : default_stiffness_factor(kinematics, joint);
}

template <int D>
double normal_stiffness(const Model& model, const std::vector<bool>& fully_held,
                        const ContactPolygonIn<D>& polygon, const PlacedPartIn<D>& reference,
                        const PlacedPartIn<D>& incident)
{
    return model.joint_between(reference.block, incident.block).stiffness.factor *
           stiffness_as_given(model, fully_held, polygon, reference, incident);
}

#define VOUSSOIR_INSTANTIATE(D)                                                                          \
    template double normal_stiffness(const Model&, const std::vector<bool>&, const ContactPolygonIn<D>&, \
                                     const PlacedPartIn<D>&, const PlacedPartIn<D>&)
VOUSSOIR_INSTANTIATE(3);
VOUSSOIR_INSTANTIATE(2);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::contact
