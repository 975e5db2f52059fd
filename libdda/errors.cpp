#include "libdda/errors.h"

#include <cstdio>
#include <cstdlib>

namespace voussoir
{

std::string to_sentence(const Fault& fault)
{
    std::string sentence = fault.place;
    if (!fault.found.empty()) sentence += (sentence.empty() ? "" : ": ") + fault.found;
    if (!fault.expected.empty()) sentence += "; " + fault.expected;
    return sentence;
}

namespace
{
std::string join(const std::vector<Fault>& faults)
{
    std::string text;
    for (const Fault& fault : faults) text += (text.empty() ? "" : "\n") + to_sentence(fault);
    return text;
}
}  // namespace

InputError::InputError(std::vector<Fault> all_faults)
    : std::runtime_error(join(all_faults)), faults(std::move(all_faults))
{
}

void assertion_failed(const char* condition, const char* file, int line)
{
    std::fprintf(stderr, "voussoir: internal error at %s:%d: %s\n", file, line, condition);
    std::abort();
}

}  // namespace voussoir
