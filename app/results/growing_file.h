// One HDF5 file of a run: what is constant, and datasets that grow.
#pragma once

#include <span>

#include "app/case/case.h"
#include "app/results/growing_rows.h"
#include "app/results/surface_mesh.h"
#include "libdda/analysis/joint_openings.h"

namespace voussoir::app::results
{

/// The beginning of another results file, to start from.
struct CopiedRows {
    std::filesystem::path file;
    std::int64_t frames = 0, history_rows = 0;
};

/// Rows that the tables of contacts have for the first frames of a results file.
/// @throws InputError when the file has fewer frames, or is damaged there
std::int64_t contact_rows_in(const std::filesystem::path& path, std::int64_t frames);

class GrowingFile
{
 public:
    /// Makes the file with the records of the model and of its joints, and empty datasets. @throws InputError
    GrowingFile(const std::filesystem::path& path, const Case& the_case, const SurfaceMesh& mesh,
                const std::vector<WatchedJoint>& joints, const std::vector<GrowingDataset>& datasets);

    /// Copies the rows of the first frames. @throws InputError when the file has fewer, or rows of another length
    void copy(const CopiedRows& rows);
    /// Rows wait in memory for flush(), so that those of many frames are one write.
    void append(const std::vector<Rows>& rows);
    /// What is known only at the end of a run.
    void write_end(const std::string& summary, std::span<const JointPeaks> peaks);
    /// What was appended reaches the operating system, and /frames/count counts it.
    void flush();
    void close();

 private:
    struct Waiting {
        RowValues values;
        std::uint64_t count = 0;
    };
    std::size_t series_named(const std::string& name) const;
    void write_waiting(std::size_t index);
    void write_waiting();

    Hdf5File file_;
    std::vector<Hdf5Series> series_;
    std::vector<Waiting> waiting_;  // of each series
};

}  // namespace voussoir::app::results
