// What grows in results.h5: datasets, and the rows that are added to them.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/results/hdf5_file.h"

namespace voussoir::app::results
{

/// A dataset that grows along its first axis.
struct GrowingDataset {
    std::string name;
    ElementType type = ElementType::float64;
    Extents row;                           // extents of one row; empty for one number per row
    std::vector<std::string> columns;      // names of the numbers in a row, for an attribute; none if empty
    std::uint64_t chunk_bytes = 1U << 18;  // by which the file grows, about
};

using RowValues =
    std::variant<std::vector<double>, std::vector<float>, std::vector<std::int64_t>, std::vector<std::int32_t>>;

/// Rows for one of them.
struct Rows {
    std::string name;
    RowValues values;
    std::uint64_t count = 1;
};

}  // namespace voussoir::app::results
