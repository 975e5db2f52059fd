// What the user got wrong, and what we got wrong. Numerical failure is neither: see StepOutcome.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace voussoir
{

/// One fault of the input: where it stands, what was found there, what was expected.
struct Fault {
    std::string place;     // "arch.yaml:14: stages[1].time_step", "bridge.obj: voussoir_12"
    std::string found;     // "-0.001 s", "two faces share edge (3, 7) in the same direction"
    std::string expected;  // "must be > 0", "give every face an outward orientation"
};

/// `place = found, expected`, one sentence.
std::string to_sentence(const Fault& fault);

/// The user's input cannot be used. Carries every fault that was found, not only the first.
class InputError : public std::runtime_error
{
 public:
    /// @param all_faults at least one
    explicit InputError(std::vector<Fault> all_faults);
    /// One fault.
    InputError(std::string place, std::string found, std::string expected)
        : InputError(std::vector<Fault>{{std::move(place), std::move(found), std::move(expected)}})
    {
    }
    std::vector<Fault> faults;  // in the order in which they were found
};

/// Says what was not so, and where, and ends the program.
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

}  // namespace voussoir

/// @def DDA_ASSERT
/// Our own mistakes; on in every build but release.
#ifdef NDEBUG
#define DDA_ASSERT(condition) static_cast<void>(0)
#else
#define DDA_ASSERT(condition) \
    ((condition) ? static_cast<void>(0) : ::voussoir::assertion_failed(#condition, __FILE__, __LINE__))
#endif
