#include "app/results/twin_files.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <new>
#include <system_error>
#include <utility>

#include "app/results/atomic_file.h"

namespace voussoir::app::results
{

namespace fs = std::filesystem;

namespace
{

fs::path with_suffix(fs::path path, const char* suffix)
{
    path += suffix;
    return path;
}

/// HDF5 does not survive a failed allocation, so it is called only where there is room for what it needs.
/// @throws std::bad_alloc
void require_memory()
{
    constexpr std::size_t enough = std::size_t{40} << 20;
    ::operator delete(::operator new(enough));
}

void rename_file(const fs::path& from, const fs::path& to)
{
    if (std::rename(from.c_str(), to.c_str()) != 0) refuse_writing(to, errno);
}

}  // namespace

TwinFiles::TwinFiles(const fs::path& results_file, const Case& the_case, const SurfaceMesh& mesh,
                     const std::vector<WatchedJoint>& joints, const std::vector<GrowingDataset>& datasets,
                     const std::optional<CopiedRows>& begin_with)
    : results_(results_file),
      next_(with_suffix(results_file, ".next")),
      former_(with_suffix(results_file, ".last"))
{
    require_memory();
    remove_twin();  // a killed run's; it may be a second name of results.h5, so it must not be written into
    const auto make = [&](const fs::path& path) {
        auto file = std::make_unique<GrowingFile>(path, the_case, mesh, joints, datasets);
        if (begin_with) file->copy(*begin_with);
        file->flush();
        return file;
    };
    try {
        back_ = make(former_);
        front_ = make(next_);
        sync_file(next_);
        rename_file(next_, results_);
        rename_file(former_, next_);
    } catch (...) {
        remove_twin();
        throw;
    }
}

TwinFiles::~TwinFiles()
{
    remove_twin();
}

void TwinFiles::remove_twin()
{
    std::error_code none;
    fs::remove(next_, none);
    fs::remove(former_, none);
}

void TwinFiles::restore_name(const fs::path& results_file)
{
    std::error_code none;
    const fs::path former = with_suffix(results_file, ".last");
    if (!fs::exists(results_file, none) && fs::exists(former, none)) rename_file(former, results_file);
}

void TwinFiles::add(std::vector<Rows> rows)
{
    for (const Rows& each : rows)
        held_bytes_ +=
            std::visit([](const auto& values) { return values.size() * sizeof values[0]; }, each.values);
    added_.push_back(std::move(rows));
}

void TwinFiles::catch_up()
{
    require_memory();
    for (const auto* batches : {&last_, &added_})
        for (const std::vector<Rows>& rows : *batches) back_->append(rows);
}

void TwinFiles::change_names()
{
    // The second name keeps the former file when the first goes over to the other.
    if (::link(results_.c_str(), former_.c_str()) != 0) rename_file(results_, former_);
    rename_file(next_, results_);
    rename_file(former_, next_);
}

void TwinFiles::store()
{
    if (added_.empty()) return;
    catch_up();
    back_->flush();
    sync_file(next_);
    change_names();
    std::swap(front_, back_);
    last_ = std::exchange(added_, {});
    held_bytes_ = 0;
}

void TwinFiles::finish(const std::string& summary, std::span<const JointPeaks> peaks)
{
    catch_up();
    back_->write_end(summary, peaks);
    back_->flush();
    back_->close();
    sync_file(next_);
    rename_file(next_, results_);
    front_->close();
}

}  // namespace voussoir::app::results
