// Runs of the program that are killed at random moments and resumed until they end.
#pragma once

#include <filesystem>
#include <string>

namespace voussoir::killed_runs
{

/// What the resumed run must be, bit for bit.
struct Reference {
    std::filesystem::path case_file, folder;
    double wall_time = 0;          // s, of the program
    std::string save_every = "0";  // s of computing; 0: with every frame
};

/// Spatial deformable, planar rigid: shaken so that joints slide and open; every frame a few steps.
extern const std::string shaken_tower, shaken_frame;

/// Runs the case without interruption in a folder below `work`.
Reference run_through(const std::filesystem::path& work, const std::string& case_text);

struct Kills {
    int kills = 0;           // that hit a living run
    int interrupts = 0;      // the same with SIGINT, which lets it finish the step
    int before_a_frame = 0;  // so early that there was nothing to resume
    int during_output = 0;   // with a twin half-written or a frame without its restart file
    int resumed_to_the_end = 0;
};

/// Kills runs of the case at random moments, each life again, resumes them, until `kills` have hit. After each
/// kill everything is readable and, saved with every frame, at most one of them is lost; every run that came to
/// its end equals the reference. Failures are GoogleTest's.
Kills kill_and_resume(const Reference& reference, const std::filesystem::path& folder, int kills, unsigned seed);

/// Both of the above for one case, with what was seen printed. @param save_every as in Reference
void kill_many(const std::string& case_text, int count, unsigned seed, const std::string& save_every = "0");

/// results.h5, histories.csv, and summary.json but for its times.
void expect_equal_results(const std::filesystem::path& folder, const std::filesystem::path& reference);

}  // namespace voussoir::killed_runs
