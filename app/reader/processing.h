// The list `processing` of a motion: what is done to a record, in the order written.
#pragma once

#include "app/reader/yaml_cursor.h"
#include "records/processing/processing.h"

namespace voussoir::app::reader
{

/// Reads `[{window: {arias: [0.1 %, 99 %]}}, mean, {band_pass: {low: 0.1 Hz, high: 25 Hz}}, ...]`.
/// @returns the steps, with faults where one cannot be used
records::processing::Processing read_processing_steps(const YamlCursor& list);

/// The same from a command line. @throws InputError with every fault
records::processing::Processing parse_processing_steps(const std::string& text, const std::string& option);

}  // namespace voussoir::app::reader
