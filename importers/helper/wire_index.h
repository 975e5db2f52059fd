// Whole numbers in what comes over the wire.
#pragma once

#include <cstdint>
#include <limits>

#include "libdda/errors.h"

namespace voussoir::importers::helper
{

/// A place in a list, or a count: json would convert a number of any size and kind to an int, whatever comes out.
template <class Json>
int index_from(const Json& value)
{
    const auto index = value.is_number_integer() ? value.template get<std::int64_t>() : -1;
    if (index < 0 || index > std::numeric_limits<int>::max())
        throw InputError("mesh", value.dump() + " is no place in a list", "the answer was damaged on the way");
    return static_cast<int>(index);
}

}  // namespace voussoir::importers::helper
