// results.h5, whole at every moment.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "app/results/growing_file.h"

namespace voussoir::app::results
{

/// HDF5 changes a file in many places, and a process may die between any two. So nothing is ever written into
/// results.h5: rows go to its twin, `results.h5.next`, and when all of them are on the disk the two change names.
/// The renaming is one act of the file system; before and after it a whole file has the name results.h5. The
/// former file is the twin of the next time, once it has caught up. The price: twice the room as long as the run
/// lasts.
class TwinFiles
{
 public:
    /// @param begin_with rows of an earlier file, maybe results.h5 itself, which is replaced when they are copied
    /// @throws InputError; a results.h5 that was there is then as it was
    TwinFiles(const std::filesystem::path& results_file, const Case& the_case, const SurfaceMesh& mesh,
              const std::vector<WatchedJoint>& joints, const std::vector<GrowingDataset>& datasets,
              const std::optional<CopiedRows>& begin_with);
    ~TwinFiles();
    TwinFiles(const TwinFiles&) = delete;
    TwinFiles& operator=(const TwinFiles&) = delete;

    void add(std::vector<Rows> rows);                       // held in memory until store()
    std::size_t held_bytes() const { return held_bytes_; }  // about
    /// What was added is in results.h5 and on the disk. @throws InputError; results.h5 is then as it was
    void store();
    /// The same, with what is known only at the end; results.h5 then stands alone.
    void finish(const std::string& summary, std::span<const JointPeaks> peaks);

    /// Gives results.h5 its name back where a process died while it had another; only file systems without hard
    /// links know such a moment.
    static void restore_name(const std::filesystem::path& results_file);

 private:
    void catch_up();
    void change_names();
    void remove_twin();

    std::filesystem::path results_, next_, former_;
    std::unique_ptr<GrowingFile> front_, back_;  // called results.h5 and next
    std::vector<std::vector<Rows>> last_;        // what the front has and the back has not
    std::vector<std::vector<Rows>> added_;       // what neither has
    std::size_t held_bytes_ = 0;                 // of added_
};

}  // namespace voussoir::app::results
