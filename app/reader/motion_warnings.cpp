#include "app/reader/motion_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/words/figures_in_words.h"

namespace voussoir::app::reader
{

void warn_of_processing(const YamlCursor& record, const records::processing::ProcessedRecord& done,
                        double further_factor)
{
    const double factor = done.factor * further_factor;
    if (std::abs(factor) > suspicious_factor)
        record.warn(
            fmt::format("the record is scaled by {:.4g}, more than {:g}: check its unit and its channel, or "
                        "take a stronger record",
                        factor, suspicious_factor));
    const double percent = std::round(100 * done.arias_share);
    if (percent < least_arias_percent)
        record.warn(
            fmt::format("the window holds {:g} % of the record's Arias intensity, less than {:g} %: the strong "
                        "part is cut; make it longer, or begin it earlier or later",
                        percent, least_arias_percent));
}

void warn_of_residual(const YamlCursor& record, const GroundMotion& motion, std::size_t samples,
                      const std::string& along)
{
    const double residual = std::abs(motion.residual_displacement());
    if (residual <= residual_length) return;
    double peak = residual;
    for (std::size_t i = 0; i < samples; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(samples);
        peak = std::max(peak, std::abs(motion.displacement(share * motion.duration())));
    }
    if (residual <= residual_share * peak) return;
    record.warn(fmt::format(
        "the ground{} ends {} from where it began, {:.0f} % of its largest displacement, and at {:.2g} m/s: "
        "unless "
        "that is what it did, add a high_pass or a baseline to its processing, and end_correction",
        along, words::length_in_words(residual), 100 * residual / peak, std::abs(motion.residual_velocity())));
}

}  // namespace voussoir::app::reader
