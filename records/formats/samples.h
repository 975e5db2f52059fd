// Samples as the formats of the networks store them: counted, in pairs with their times, beside velocities.
#pragma once

#include <string>
#include <vector>

#include "records/formats/fields.h"
#include "records/record.h"
#include "records/source_file.h"

namespace voussoir::records::formats
{

/// How many samples a header announces, and where.
struct Announced {
    double count = 0;
    std::string place;            // "file:line"
    std::size_t values_each = 1;  // 2: pairs of time and value
};

/// Judges a block of samples: adds a fault when it holds another number of them than announced, or when one is not
/// finite; one sample more than announced is accepted with a remark.
void check_block(const SourceFile& file, const NumberBlock& block, const Announced& announced,
                 std::vector<std::string>& remarks, FaultList& faults);

/// Adds a fault when a time step was asked for although the file holds the time of every sample.
void refuse_time_step(const SourceFile& file, const ReadOptions& options, FaultList& faults);

/// A header states the peak: adds a remark when the samples' differs by more than `rounding` [SI unit].
void compare_peak(const Channel& channel, double stated, double rounding, const std::string& place,
                  std::vector<std::string>& remarks);

/// (time, value) pairs.
struct TimedSamples {
    std::vector<double> times, values;
};

/// Splits pairs. Times that are printed alike because their digits did not suffice are spread evenly up to the
/// next one, and a remark says so; a fault is added when times decrease.
TimedSamples split_pairs(const SourceFile& file, const NumberBlock& block, std::vector<std::string>& remarks,
                         FaultList& faults);

/// Of a file that also holds velocity and displacement, keeps the acceleration, and says so; without any
/// acceleration, keeps all.
void keep_accelerations(Record& record);

}  // namespace voussoir::records::formats
