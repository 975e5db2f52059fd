// Results files that HDF5 reads without complaint and whose content is not what it should be: a small good one,
// and edits of it taken from bytes. For the fuzzer and for the test of damaged results.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/results/hdf5_file.h"

namespace voussoir
{

/// A dataset of numbers before it is written.
struct DraftDataset {
    app::results::ElementType type = app::results::ElementType::float64;
    app::results::Extents extents;
    std::vector<double> values;
};

/// A results file before it is written.
struct DraftResults {
    std::map<std::string, DraftDataset> numbers;
    std::map<std::string, std::vector<std::string>> texts;
    std::map<std::string, std::string> attributes;  // of the file
    double thickness = 2;
    std::vector<std::string> stress_columns{"xx", "yy", "zz", "xy", "yz", "xz"};
};

/// Two boxes, one on the other, in two frames with one joint; deformable or planar and rigid.
DraftResults two_boxes(bool planar);

/// Changes the draft as the bytes say; every sequence of bytes means something.
void edit(std::string_view bytes, DraftResults& draft);

void write_draft(const DraftResults& draft, const std::filesystem::path& path);

/// Reads everything a picture needs and computes what it draws. @throws InputError; anything else is a finding
void read_everything(const std::filesystem::path& path);

}  // namespace voussoir
