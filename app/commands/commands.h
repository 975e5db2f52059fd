// What the program can do: one function per command, called by main with the parsed command line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/case/case.h"

namespace voussoir::app::commands
{

/// What the program tells the shell.
enum ExitCode {
    exit_done = 0,
    exit_failure = 1,
    exit_bad_input = 2,
    exit_gave_up = 3,
    exit_interrupted = 4,
    exit_not_standing = 5  // of `run` alone: it has fallen, has lost stones, or it is undecided whether it stands
};

struct RunArguments {
    std::filesystem::path case_file;
    std::filesystem::path folder;  // empty: results/<case name>
    std::vector<std::string> overrides;
    std::optional<int> threads;    // none: as many as the scene is worth
    bool resume = false;           // go on with the run that was interrupted in the folder
    bool other_engine = false;     // even if another build of the program began it
    bool accept_collapse = false;  // a structure that falls is what was expected: exit_done
    double save_every = 2;         // s of computing between two savings; 0: with every frame
    bool quiet = false;
    bool verbose = false;  // every repair of a mesh, not one line a kind
};

/// Reads the case, runs its stages, writes the results and draws the pictures it asks for. Nothing is created
/// before the case is known to be good.
/// @throws InputError with all faults of the case
int run_command(const RunArguments& arguments);

struct CheckArguments {
    std::filesystem::path case_file;
    std::vector<std::string> overrides;
    std::optional<std::filesystem::path> json, folder;
    bool verbose = false;  // every repair of a mesh, not one line a kind
};

/// Reads and certifies a case, finds its contacts, and tells what is there and how it stands together; runs
/// nothing. The certificate is written, where asked for, of a case that cannot be run too.
/// @returns exit_bad_input when the case cannot be run
int check_command(const CheckArguments& arguments);

struct GenerateArguments {
    std::string what;               // a case file, or the name of a pattern
    std::vector<std::string> keys;  // of a pattern, as in a case: "span=10 m"
    std::filesystem::path output;   // .obj or .yaml
};

/// Writes the stones of a case, or of a pattern, as OBJ (one named object each) or as a case whose blocks are
/// listed one by one; reads them as `check` does first.
/// @throws InputError with all faults of the case, or when the file cannot be written
int generate_command(const GenerateArguments& arguments);

struct ImportArguments {
    std::vector<std::filesystem::path> files;
    std::optional<std::string> unit;  // of the files; as they say, or metres, if not given
    std::optional<char> up;           // as the files say, or z, if not given
    std::string stones = "detect";    // of stone_level_names
    double planarity = 1e-5, volume_error = 0.01;
    std::string fit_joints = "shared";                      // of fit_joints_names
    std::optional<std::string> close_joints;                // a length
    std::string reader = "auto";                            // of mesh_reader_names
    std::vector<std::string> skip, only, hull, skip_types;  // patterns of names of stones, and of types of items
    std::string repair = "refuse";                          // of repair_rule_names
    std::optional<std::string> simplify;                    // as in a case: "{parts: 12, volume_error: 2 %}"
    bool formats = false;                                   // list what is read, import nothing
    std::optional<std::filesystem::path> json, folder;
    bool verbose = false;  // every repair, not one line a kind
};

/// The geometry certificate of mesh files, each on its own.
/// @returns exit_bad_input when any file was refused; the others are listed all the same
int import_command(const ImportArguments& arguments);

struct RecordArguments {
    std::vector<std::filesystem::path> files;
    std::optional<std::string> unit;
    std::optional<double> time_step;  // s
    std::optional<int> column;
    std::optional<std::filesystem::path> response;  // StationXML with the sensitivity of counts
    bool together = false;                          // the files are components of one motion
    std::optional<std::string> process, motion;     // YAML, as in a case
    std::optional<std::filesystem::path> json, folder;
};

/// What accelerograms hold, what is left after processing, and files of it. @returns exit_bad_input when any file
/// was refused
int record_command(const RecordArguments& arguments);

struct RenderArguments {
    std::filesystem::path results;
    std::filesystem::path folder;  // empty: snapshots/ beside the results
    std::string color = "displacement";
    std::vector<double> times;  // s
    int count = 4;
    std::vector<int> size;  // pixels; empty: 1600 x 900, of a film 1280 x 720
    std::optional<double> deformation_scale;
    std::optional<std::filesystem::path> film;  // a film instead of pictures; empty: video.mp4 beside the results
    double frames_per_second = 25, slow_down = 1;
    LookOptions look;
    int jobs = 0;  // pictures drawn at once; 0: as many as there are cores
};

/// Pictures or a film from a results file, without a run.
int render_command(const RenderArguments& arguments);

struct ReportArguments {
    std::filesystem::path results;  // the file, or the folder of a run
    std::filesystem::path folder;   // empty: where the results are
    bool no_film = false;
    bool quiet = false;
};

/// The report of a run, from its results: a page, and the same as text and tables.
int report_command(const ReportArguments& arguments);

struct CompareArguments {
    std::filesystem::path a, b;    // results files, or folders of runs
    std::filesystem::path folder;  // empty: comparison
    bool no_film = false;
    bool quiet = false;
};

/// Two runs side by side, from their results: a page, and the same as text and tables.
int compare_command(const CompareArguments& arguments);

constexpr std::uint64_t default_verify_seed = 1;

struct VerifyArguments {
    std::vector<std::string> names;  // empty: all
    bool list = false, sweep = false;
    bool tables = false;  // the page of docs/: tables and one diagram
    std::uint64_t seed = default_verify_seed;
    std::optional<std::filesystem::path> json, folder;
};

/// Reruns the benchmarks the method is judged by, beside their references. @returns exit_failure when a row fails
/// @throws InputError for an unknown name
int verify_command(const VerifyArguments& arguments);

struct StabilityArguments {
    std::vector<std::string> names;  // scenes or cells; empty: all
    bool list = false;
    bool tables = false;  // the page of docs/: tables and one map
    int jobs = 1;
    double tolerance_factor = 1;  // times the tolerance of every cell
    std::optional<std::filesystem::path> json, folder;
};

/// Runs the stiff and extreme scenes, each cell in a process of its own: the failure map. @returns exit_failure
/// when a cell is wrong, crashes or takes too long
/// @throws InputError for an unknown name
int stability_command(const StabilityArguments& arguments);

struct ConvergeArguments {
    std::filesystem::path case_file;
    std::vector<std::string> overrides, quantities;
    std::vector<std::string> time_steps, integrators;  // empty: the defaults
    std::vector<double> stiffness_factors;             // empty: the default
    std::optional<std::string> threshold;              // KEY=STANDS..COLLAPSES, in place of quantities
    std::string collapse_displacement = "1";           // block sizes, a length, or none
    std::string bracket = "1 %";                       // of a threshold
    std::string tolerance = "5 %";                     // wanted, for the conclusion
    int threads = 1;
    std::optional<std::filesystem::path> json, folder;
    bool quiet = false;
};

/// Error against run time of the user's own case, over time steps and contact stiffness. @returns exit_gave_up
/// when no run gave a value
/// @throws InputError with all faults of the case or of the choices
int converge_command(const ConvergeArguments& arguments);

struct LimitArguments {
    std::filesystem::path case_file;
    std::vector<std::string> overrides;
    std::vector<double> towards;  // three numbers
    std::optional<std::filesystem::path> json, folder;
    bool quiet = false;
};

/// Limit analysis of rigid stones under a body force in one direction. @returns exit_gave_up where there is no
/// limit: the stones do not stand, or under any force
/// @throws InputError with all faults of the case or of the choices
int limit_command(const LimitArguments& arguments);

struct EnsembleArguments {
    std::filesystem::path case_file;
    std::vector<std::string> overrides;
    std::string vary;             // KEY=VALUE,VALUE,...
    std::string open = "1 mm";    // a joint that is open by more counts
    double stiffness_factor = 2;  // of the sensitivity; 1: none
    int jobs = 1;                 // runs side by side
    std::optional<std::filesystem::path> json, folder;
    bool quiet = false;
};

/// Runs of a case that differ by next to nothing, at its time step and at half of it: what the step does to their
/// medians, beside what chance does. @returns exit_done whatever the study says, exit_gave_up when a run gave up
/// @throws InputError with all faults of the case or of the choices
int ensemble_command(const EnsembleArguments& arguments);

}  // namespace voussoir::app::commands
