// How stiff the normal springs of a contact are.
#pragma once

#include "libdda/contact/contact_polygon.h"
#include "libdda/contact/placed_part.h"

namespace voussoir::contact
{

/// The default stiffness of a joint, in E / L of the stones on its sides. A joint that is f E / L stiff adds 1/f
/// to the compliance of elastic stones and takes 1/(2f) from the frequencies of the structure: 0.17 % if
/// bonded, 1.7 % if dry. Dry joints as stiff as bonded ones would cost ten times the iterations where many of them
/// open and close in a step; those of rigid stones, which rock harder, are softer still.
double default_stiffness_factor(Kinematics kinematics, const JointMaterial& joint);

/// Gives the joints of rigid stones of which nobody said how stiff they are 300 E / L: for a model that only has
/// to carry its weight, as it comes to rest or under all of it at once. Shaken stones on such joints rattle, which
/// costs up to ten times the iterations and what the integrator takes; at rest they cost half as many again, and
/// limit states come closer to those of rigid bodies.
void stiffen_for_rest(Model& model);

/// How many E / L a joint has whose stiffness comes from the moduli: those given, else the default.
double times_modulus(Kinematics kinematics, const JointMaterial& joint);

/// What turns a measure of a contact into an area [m]: lengths of a planar scene count times its thickness.
template <int D>
double depth_of(const Model& model)
{
    return D == 3 ? 1 : model.thickness;
}

/// Of a contact that is new, or new to its face [Pa/m]: as the joint of the two blocks has it, times its factor.
/// Of one that comes from the moduli it is the series modulus of the two half blocks on either side of the joint,
/// k = 2 f / (L_a/E_a + L_b/E_b), which is f E / L for equal blocks; a held block adds no compliance.
/// @param reference, incident parts of a scene in order of block and part, as place_parts leaves them
/// @param fully_held (blocks)
template <int D>
double normal_stiffness(const Model& model, const std::vector<bool>& fully_held,
                        const ContactPolygonIn<D>& polygon, const PlacedPartIn<D>& reference,
                        const PlacedPartIn<D>& incident);

}  // namespace voussoir::contact
