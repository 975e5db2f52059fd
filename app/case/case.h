// A case as data, ready to run, whoever has read or made it.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/stage.h"

namespace voussoir::app
{

/// A block, and a reference point of it, whose history is written.
struct HistoryPoint {
    std::string name;
    std::string block;
    std::optional<Eigen::Vector3d> point;  // m, user's coordinates; the centroid if absent
};

/// A bar whose forces are written.
struct BarHistory {
    std::string name;
    int bar = 0;  // index into Model::bars
};

/// What the colours of a picture show: of each vertex its displacement relative to the foot; of each stone its
/// largest compressive principal stress or strain, its speed, the largest opening or slip of its joints, the
/// largest share of friction that one of them uses, or its group.
enum class SnapshotColor {
    displacement,
    principal_stress,
    velocity,
    opening,
    slip,
    friction,
    principal_strain,
    group
};

/// What a picture shows beside the stones, and from where; words as on the command line.
struct LookOptions {
    std::vector<std::string> hidden;  // patterns of names of stones, or of groups; * and ? stand for others
    std::vector<std::string> cuts;    // "x>1.5": stones whose centroid is there before the run are left out [m]
    std::vector<std::string> labels;  // patterns of names of stones that are written on them
    std::string view;    // "front", "right", "back", "left", "top", "AZIMUTH,ELEVATION" [deg]; empty: as usual
    std::string follow;  // a pattern of names, or "structure": the camera goes with it; empty: it stands still
    double orbit = 0;    // deg by which the viewer turns in the course of a film
    bool orthographic = false;
    bool forces = false;  // of the contacts, and the line of thrust
    bool ground = false;  // the acceleration of the ground as an arrow
};

struct SnapshotOptions {
    SnapshotColor color = SnapshotColor::displacement;
    LookOptions look;
    std::vector<double> times;  // s of run time; empty: `count` snapshots spread over the run
    int count = 4;
    int width = 1600, height = 900;
    std::optional<double> deformation_scale;  // displacements drawn times this; 1 if absent
    int jobs = 0;                             // pictures drawn at once; 0: as many as there are cores
};

/// Whether a run seeks the structure's natural modes to say how much it is to be trusted.
enum class TrustFigures {
    automatic,  // where that costs little beside the run
    always,
    never,  // nothing is judged
};

enum class FilmFormat { mp4, gif, webp };

struct FilmOptions {
    SnapshotColor color = SnapshotColor::displacement;
    LookOptions look;
    FilmFormat format = FilmFormat::mp4;
    int width = 1280, height = 720;           // even
    double frames_per_second = 25;            // of the film
    double slow_down = 1;                     // seconds of film for a second of the run
    std::optional<double> deformation_scale;  // displacements drawn times this; 1 if absent
    int jobs = 0;                             // frames drawn at once; 0: as many as there are cores
};

struct OutputOptions {
    double every = 0;  // s between frames in results.h5
    TrustFigures trust = TrustFigures::automatic;
    bool error_estimate = false;  // the run is repeated with half the time step and with twice the stiffness
    std::vector<HistoryPoint> histories;
    std::vector<BarHistory> bar_histories;
    std::optional<SnapshotOptions> snapshots;  // absent: no renderer is started
    std::optional<FilmOptions> film;           // absent: none, and ffmpeg is not started
    bool report = false;                       // report.html and its companions at the end of the run
};

/// What was read about a record or a wave, for the report and `left_out`.
struct MotionNote {
    std::string description;  // "foundation x: records/aqv_we.at2 (PEER AT2, 0.005 s, 6.5 m/s2) x 1.5"
    double residual_velocity = 0, residual_displacement = 0, peak_acceleration = 0;
};

/// A case, ready to run.
struct Case {
    std::filesystem::path file;
    std::string title;
    std::string text;                     // the case file as read, with --set applied noted in `overrides`
    std::vector<std::string> overrides;   // "stages[1].time_step=1 ms"
    std::vector<std::string> mesh_files;  // as the case names them; empty: no geometry helper was started
    Model model;
    std::vector<Stage> stages;
    OutputOptions output;
    std::vector<MotionNote> motions;
    std::vector<std::string> defaults;  // every default that was taken, in words
    std::vector<std::string> warnings;  // repairs included
};

}  // namespace voussoir::app
