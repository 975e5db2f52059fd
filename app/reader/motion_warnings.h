// What was done to a record and may have been meant otherwise: warnings, no faults.
#pragma once

#include "app/reader/yaml_cursor.h"
#include "libdda/model/ground_motion.h"
#include "records/processing/processing.h"

namespace voussoir::app::reader
{

/// A record scaled by more than this is another earthquake, or has another unit than was thought.
constexpr double suspicious_factor = 10;  // -
/// The least percentage of a record's Arias intensity that windows should leave of it.
constexpr double least_arias_percent = 70;
/// The ground should end nearer to its place than this share of its largest displacement, or than this length.
constexpr double residual_share = 0.2;    // -
constexpr double residual_length = 0.01;  // m

/// Warns of a factor and of windows. @param further_factor beside those of the steps
void warn_of_processing(const YamlCursor& record, const records::processing::ProcessedRecord& done,
                        double further_factor);

/// Warns of a motion that ends far from where it began. @param samples as many as it has; @param along
/// " along x", or nothing
void warn_of_residual(const YamlCursor& record, const GroundMotion& motion, std::size_t samples,
                      const std::string& along);

}  // namespace voussoir::app::reader
