// What results.h5 holds once per frame.
#pragma once

#include "app/results/hdf5_file.h"
#include "app/results/surface_mesh.h"
#include "libdda/model/report.h"

namespace voussoir
{

/// Growing datasets under /frames. The number of frames is written when all of a frame is safe in the file: what
/// lies beyond it is unfinished.
class FrameRecords
{
 public:
    FrameRecords(const Model& model, Hdf5File& file);
    /// Appends a frame, flushes it, then counts it.
    void append(const Model& model, const SurfaceMesh& mesh, const State& state, const RunReport& report,
                Hdf5File& file);

 private:
    struct Joints {
        Hdf5Series rows, pair, force, moment, centre, pressure_centre, normal, normal_force, opening, slip, area,
            closed_area;
    };
    void make_joints(Kinematics kinematics, Hdf5File& file);
    void append_joints(const Model& model, const State& state, Hdf5File& file);
    void append_stresses(const Model& model, const SurfaceMesh& mesh, const State& state, Hdf5File& file);

    Hdf5Series time_, step_, stage_, coordinates_, velocities_, ground_, positions_, face_displacement_, energy_,
        report_;
    Hdf5Series stress_, face_least_stress_, face_greatest_stress_;  // deformable scenes only
    Joints joints_;
};

}  // namespace voussoir
