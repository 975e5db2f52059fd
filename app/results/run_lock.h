// One run at a time in a folder.
#pragma once

#include <filesystem>

namespace voussoir::app::results
{

/// Holds `run.lock` in a folder of results, made if need be, as long as it lives. The lock belongs to the process:
/// one that is killed leaves none behind, whatever file it leaves.
class RunLock
{
 public:
    /// @throws InputError when another run writes into the folder, or nothing can be written there
    explicit RunLock(const std::filesystem::path& folder);
    ~RunLock();
    RunLock(const RunLock&) = delete;
    RunLock& operator=(const RunLock&) = delete;

 private:
    std::filesystem::path path_;
    int descriptor_ = -1;
};

}  // namespace voussoir::app::results
