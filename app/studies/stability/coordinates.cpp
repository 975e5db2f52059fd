// Far from the coordinate origin, as a case file meets it.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "app/case/case.h"
#include "app/studies/stability/engine.h"
#include "app/studies/stability/families.h"
#include "libdda/errors.h"

namespace voussoir::app::studies::stability
{
namespace
{

using Eigen::Vector3d;

/// A folder that goes with what is in it.
class ScratchFolder
{
 public:
    ScratchFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "voussoir-cell-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw InputError(name, "it cannot be created", "a writable folder");
        path_ = name;
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    const std::filesystem::path& path() const { return path_; }

 private:
    std::filesystem::path path_;
};

/// A slab on an incline of 30 degrees, all `x` east and `x` south of the origin.
std::string case_text(double x, const std::string& kinematics)
{
    const auto box = [x](const char* name, const Vector3d& lower, const Vector3d& upper) {
        return fmt::format(
            "  - box: {{name: {}, lower: [{:.10g}, {:.10g}, {:g}], upper: [{:.10g}, {:.10g}, {:g}], "
            "rotate: {{axis: [0, 1, 0], angle: 30 deg, about: [{:.10g}, {:.10g}, 0]}}}}\n",
            name, lower.x() + x, lower.y() - x, lower.z(), upper.x() + x, upper.y() - x, upper.z(), x, -x);
    };
    return "title: far away\nkinematics: " + kinematics +
           "\nmaterials: {stone: {density: 2000 kg/m3, young: 10 GPa, poisson: 0.2}}\n"
           "joints: {dry: {friction: 10 deg}}\nblocks:\n" +
           box("plane", {-2, -2, -1}, {10, 2, 0}) + "    group: foundation\n" +
           box("slab", {-0.5, -0.5, 0}, {0.5, 0.5, 0.125}) +
           "foundation: {blocks: foundation}\n"
           "stages: [{name: sliding, type: dynamic, duration: 1 s, time_step: 1 ms}]\n";
}

/// How far the slab slides [m]; not counted without a cell.
Vector3d slide(double x, const std::string& kinematics, const ScratchFolder& folder, const CaseReader& read_case,
               CellRun* cell)
{
    const std::filesystem::path file = folder.path() / "far_away.yaml";
    std::ofstream(file) << case_text(x, kinematics);
    const Case the_case = read_case(file, {});
    State state = initial_state(the_case.model);
    const Vector3d start = pose_of(the_case.model.kinematics, state, 1).centroid;
    if (cell)
        run_counted(the_case.model, the_case.stages, state, {}, *cell);
    else
        run_reference(the_case.model, the_case.stages, state, {});
    return pose_of(the_case.model.kinematics, state, 1).centroid - start;
}

CellRun run_far_away(double x, const std::string& kinematics, const CaseReader& read)
{
    const ScratchFolder folder;
    CellRun cell;
    const Vector3d there = slide(x, kinematics, folder, read, &cell),
                   here = slide(0, kinematics, folder, read, nullptr);
    cell.error = (there - here).norm() / here.norm();
    return cell;
}

}  // namespace

StabilityScene coordinate_scene(const CaseReader& read)
{
    StabilityScene scene;
    scene.name = "coordinates";
    scene.title = "Far from the coordinate origin";
    scene.quantity = "difference of the displacements / distance slid";
    scene.text =
        "A case file: a slab slides for 1 s down an incline of 30 degrees with friction of 10 degrees, x and -x "
        "metres from the origin, as in the coordinates of national grids.";
    scene.reference = "the same case at the origin";
    scene.tolerance = 1e-3;
    for (const char* kinematics : {"spatial_rigid", "spatial_deformable"})
        for (const double x : {1e3, 1e4, 1e5, 1e6, 1e7})
            add_cell(scene, fmt::format("{}-x={:.0e}", kinematics, x), {{kinematics, x, "m"}}, 1e-3,
                     [=] { return run_far_away(x, kinematics, read); });
    return scene;
}

}  // namespace voussoir::app::studies::stability
