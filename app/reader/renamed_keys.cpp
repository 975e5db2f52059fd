#include "app/reader/renamed_keys.h"

namespace voussoir::app::reader
{
namespace
{

struct RenamedKey {
    std::string_view before, now;
};

// A line stays for one release. No key may stand here that is still the name of something else.
constexpr RenamedKey renamed_keys[] = {
    {"dashpot", "relaxation_time"},  // of a joint: it is a time, damping coefficient over stiffness
};

}  // namespace

std::string_view former_name(std::string_view key)
{
    for (const RenamedKey& renamed : renamed_keys)
        if (renamed.now == key) return renamed.before;
    return {};
}

std::string_view present_name(std::string_view former_key)
{
    for (const RenamedKey& renamed : renamed_keys)
        if (renamed.before == former_key) return renamed.now;
    return {};
}

}  // namespace voussoir::app::reader
