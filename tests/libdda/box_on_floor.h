// A small box on a large one, and what their contact remembers from step to step.
#pragma once

#include <vector>

#include "libdda/contact/find_contacts.h"
#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

/// Both free to be put anywhere; found 5 mm away.
struct BoxOnFloor {
    Model model = make_model(Kinematics::spatial_deformable, stone(), dry(30));
    State state;

    explicit BoxOnFloor(const Eigen::Vector3d& floor = {4, 4, 1})
    {
        add_box(model, "floor", -0.5 * floor, 0.5 * floor);
        add_box(model, "box", {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
        state = initial_state(model);
    }
    void put(const Eigen::Vector3d& centre, const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity())
    {
        set_pose(model, state, 1, centre, rotation);
    }
    ContactSet find(contact::NewOverlap overlap = contact::NewOverlap::presses) const
    {
        ContactSet found;
        contact::SearchMemory<3> search;
        contact::find_contacts(model, state, std::vector<double>(2, 5e-3), 1, search, found, overlap);
        return found;
    }
    void remember(const ContactSet& found)
    {
        state.contacts.patches = found.patches;
        state.contacts.points = found.points;
    }
};

}  // namespace voussoir::testing
