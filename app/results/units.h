// The units of what results.h5 holds.
#pragma once

#include <string_view>

namespace voussoir::app::results
{

/// "m", "N", ... of a dataset, which has it as the attribute `unit`; empty where it has none of its own: counts,
/// indices, names, and tables whose columns differ and are named.
std::string_view unit_of(std::string_view dataset);

}  // namespace voussoir::app::results
