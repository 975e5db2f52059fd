#include "app/studies/scenes/scene_blocks.h"

#include "app/studies/scenes/materials.h"
#include "libdda/contact/initial_contacts.h"

namespace voussoir::app::studies::scenes
{
namespace
{

template <int D>
StartContact first_of(const ContactSetIn<D>& contacts)
{
    double area = 0;
    for (const ContactPointIn<D>& point : contacts.points) area += point.area;
    return {contacts.patches.at(0).stiffness, area / static_cast<double>(contacts.points.size())};
}

}  // namespace

Model make_scene_model(const SceneSetting& setting, const BlockMaterial& material, const JointMaterial& joint,
                       double thickness)
{
    Model model = make_model(setting.kinematics, material, joint_in(setting, joint));
    model.thickness = thickness;
    model.plane = PlaneCondition::stress;
    return model;
}

int add_box(Model& model, const std::string& name, const Eigen::Vector3d& lower, const Eigen::Vector3d& upper)
{
    if (is_planar(model.kinematics))
        model.blocks.push_back(make_planar_block(
            name, 0, 0, {make_rectangle(from_space<2>(lower), from_space<2>(upper))}, model.thickness));
    else
        model.blocks.push_back(make_block(name, 0, 0, {make_box(lower, upper)}));
    return static_cast<int>(model.blocks.size()) - 1;
}

void hold(Model& model, int block)
{
    Foundation foundation;
    foundation.block = block;
    model.foundations.push_back(foundation);
}

void set_velocity(const Model& model, State& state, int block, const Eigen::Vector3d& velocity)
{
    double* first = state.velocities.data() + block * unknowns_per_block(model.kinematics);
    if (is_planar(model.kinematics))
        Eigen::Map<Eigen::Vector2d>{first} = from_space<2>(velocity);
    else
        Eigen::Map<Eigen::Vector3d>{first} = velocity;
}

StartContact start_contact(const Model& model)
{
    State state = initial_state(model);
    find_initial_contacts(model, state);
    return is_planar(model.kinematics) ? first_of(state.planar_contacts) : first_of(state.contacts);
}

}  // namespace voussoir::app::studies::scenes
