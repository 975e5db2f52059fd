// Columns of elastic stones that bend: sag and first frequency against the beam with shear.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "app/studies/scenes/shapes.h"
#include "app/studies/verify/families.h"
#include "app/studies/verify/picture.h"
#include "app/studies/verify/references/beam.h"
#include "app/studies/verify/run_scene.h"
#include "app/studies/verify/settings.h"
#include "libdda/analysis/modes.h"

namespace voussoir::app::studies::verify
{

namespace
{

using Eigen::Vector3d;

// Stiff, so that the weight of a dry column does not count against its bending.
constexpr double young = 1e11, poisson = 0.2, density = 2400;
constexpr double strong = 1e9;     // Pa: no joint breaks
constexpr double sideways = 1e-3;  // of gravity, on dry columns

/// A column of cubes, or of stones of other heights, on the ground.
struct Column {
    int stones = 1;
    double height = 1;  // m, of a stone; all are 1 m wide
    bool bonded = true;

    references::Cantilever as_beam() const { return {stones * height, 1, 1, density, young, poisson}; }
};

scenes::StagedScene column_scene(const scenes::SceneSetting& setting, const Column& column,
                                 const Vector3d& gravity)
{
    scenes::StagedScene scene;
    JointMaterial joint = scenes::dry_joint(1);
    if (column.bonded) joint.cohesion = joint.tensile_strength = strong;
    BlockMaterial material = scenes::stone(density, young);
    material.poisson = poisson;
    scene.model = scenes::make_scene_model(setting, material, joint, 1);
    scenes::hold(scene.model, scenes::add_box(scene.model, "base", {-2, -2, -1}, {2, 2, 0}));
    for (int i = 0; i < column.stones; ++i)
        scenes::add_box(scene.model, fmt::format("stone {}", i + 1), {-0.5, -0.5, i * column.height},
                        {0.5, 0.5, (i + 1) * column.height});
    scene.stages = {scenes::static_stage(setting, gravity)};
    return scene;
}

/// Sag of the top stone's centroid, over that of the beam.
double sag_of(const scenes::SceneSetting& setting, const Column& column, VerifyResult& result)
{
    // A bonded column is pulled aside by nothing else, a dry one under its weight: it stays pressed all over.
    const double g = scenes::papers_gravity, pull = (column.bonded ? 1 : sideways) * g;
    const scenes::StagedScene scene = column_scene(setting, column, {pull, 0, column.bonded ? 0 : -g});
    State state = initial_state(scene.model);
    run_scene(scene, state, {}, result);
    std::vector<double> heights{0}, sags{0}, exact{0};
    for (int i = 0; i < column.stones; ++i) {
        heights.push_back((i + 0.5) * column.height);
        sags.push_back(pose_of(scene.model.kinematics, state, i + 1).centroid.x());
        exact.push_back(references::sag_at(column.as_beam(), pull, heights.back()));
    }
    result.picture = linear_diagram("height [m]", "sag [m]",
                                    {curve_of("engine", heights, sags), curve_of("beam", heights, exact)});
    return sags.back() / exact.back();
}

/// Its first frequency as `check` has it, over that of the beam.
double frequency_of_column(const scenes::SceneSetting& setting, const Column& column)
{
    const scenes::StagedScene scene = column_scene(setting, column, Vector3d::Zero());
    const NaturalModes found = natural_modes(scene.model, initial_state(scene.model), {.count = 1});
    return found.modes.empty() ? 0 : found.modes[0].frequency / references::sway_frequency(column.as_beam());
}

/// Its first frequency of twisting, over that of the beam: the mode in which no stone moves aside.
double twist_of_column(const scenes::SceneSetting& setting, const Column& column)
{
    const scenes::StagedScene scene = column_scene(setting, column, Vector3d::Zero());
    const NaturalModes found = natural_modes(scene.model, initial_state(scene.model), {.count = 8});
    for (const NaturalMode& mode : found.modes)
        if (mode.mass_share.sum() < 1e-6) return mode.frequency / references::twist_frequency(column.as_beam());
    return 0;
}

VerifyResult run_columns(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.note = "sag, first frequency / those of the beam:";
    for (const Column& column :
         {Column{8, 0.5}, {6, 1}, {10, 1}, {10, 2}, {40, 0.5}, {10, 1, false}, {40, 0.5, false}}) {
        const double sag = sag_of(setting, column, result), frequency = frequency_of_column(setting, column);
        for (const double ratio : {sag, frequency}) {
            result.answer.push_back(ratio);
            result.error = std::max(result.error, std::abs(ratio - 1));
        }
        std::string twist;
        if (!is_planar(setting.kinematics)) {
            const double ratio = twist_of_column(setting, column);
            result.error = std::max(result.error, std::abs(ratio - 1));
            twist = fmt::format(", twisting {:.4f}", ratio);
        }
        result.note += fmt::format(" {:.4f}, {:.4f}{} ({} x {:g} m, {}),", sag, frequency, twist, column.stones,
                                   column.height, column.bonded ? "bonded" : "dry");
    }
    result.note.pop_back();
    return result;
}

}  // namespace

std::vector<Benchmark> column_benchmarks()
{
    Benchmark columns;
    columns.setting.kinematics = Kinematics::spatial_deformable;
    columns.name = "elastic-columns";
    columns.title = "Columns of elastic stones that are pulled aside, and vibrate";
    columns.source = "docs/faces.md: Timoshenko's cantilever; not from a paper";
    columns.quantity = "largest |sag or frequency / that of the beam - 1|";
    columns.choices =
        "6 to 40 stones of 1 x 1 m and 0.5 to 2 m height, 100 GPa, slenderness 4 to 20, bonded or dry under their "
        "weight, default "
        "stiffness of joints; pulled aside by their weight or, dry, by a thousandth of it. Of n stones the sag is "
        "1 + 1/n^2 times that "
        "of the beam, for each turns at its faces. Frequencies are those that `check` prints.";
    columns.tolerance = 0.03;
    columns.run = run_columns;
    return with_planar({columns});
}

}  // namespace voussoir::app::studies::verify
