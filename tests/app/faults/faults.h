// Every call of the system, and every allocation, fails once at each place it is made from (fail_once.cpp):
// nothing crashes, nothing is left half written under its own name, exit code 0 means that everything is there,
// and what can be resumed comes to the same end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace voussoir::faults
{

/// A place that calls the system or asks for memory.
struct CallSite {
    std::uint64_t number = 0;
    std::string kind;     // "write", "memory", ...
    bool ours = false;    // false: memory that a library asks for
    std::string program;  // that calls it: voussoir or a helper
};

/// A command on the smallest case that reaches its call sites, and what it leaves when nothing fails.
class Scenario
{
 public:
    /// @param name run, resume, import or picture. @param home an empty folder, which it makes its own
    Scenario(std::string name, const std::filesystem::path& home);

    const std::string& name() const { return name_; }
    /// Of one undisturbed run of the command.
    const std::vector<CallSite>& sites() const { return sites_; }
    /// Lets the site fail at its `time`-th call, and checks what becomes of it. Failures are GoogleTest's.
    /// @returns how it ended: "exit 1", "exit 0", "signal 11", "not reached"
    std::string try_fault(const CallSite& site, int time) const;
    /// The same of a library's own allocation: how it ends is counted, not judged.
    std::string watch_fault(const CallSite& site) const;

 private:
    struct Outcome;
    Outcome start(const std::filesystem::path& work, const std::vector<std::string>& environment) const;
    void prepare(const std::filesystem::path& work) const;
    Outcome fail(const std::filesystem::path& work, const CallSite& site, int time, bool& reached) const;
    void check_run(const std::filesystem::path& work, const Outcome& outcome) const;

    std::string name_;
    std::filesystem::path home_;
    std::vector<CallSite> sites_;
};

/// Tries sites one after another, and prints how many of each kind ended how.
/// @param time of the call that fails; 0: only watched, at the first
/// @returns the sites that did not survive
int try_all(const Scenario& scenario, const std::vector<CallSite>& sites, int time);

}  // namespace voussoir::faults
