// Notes, when the motion of a run begins, by what the run is to be judged at its end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "libdda/analysis/trust.h"

namespace voussoir::app::commands
{

/// Prints how far a run can be trusted.
/// @returns what was found; nothing where no motion began
std::optional<Trust> print_trust(const Case& the_case, const std::optional<TrustStart>& noted,
                                 const RunReport& report);

class TrustWatch
{
 public:
    /// @param earlier what was noted before a resume
    TrustWatch(const Case& the_case, const std::optional<TrustStart>& earlier) : case_(the_case), start_(earlier)
    {
    }

    /// Called with every frame. Where this one is the last before the motion begins, the structure's modes are
    /// sought. @returns what has been noted just now
    const TrustStart* frame(const State& state, const RunReport& report);

    /// What was noted; none before the motion and where the case does not ask.
    const std::optional<TrustStart>& start() const { return start_; }

 private:
    bool is_due(const State& state) const;

    const Case& case_;
    std::optional<TrustStart> start_;
};

}  // namespace voussoir::app::commands
