#include "app/words/figures_in_words.h"

#include <fmt/format.h>

#include <cmath>

namespace voussoir::app::words
{

std::string error_in_words(double error)
{
    if (error == 0) return "0";
    return error >= 1e-3 ? fmt::format("{:.3g} %", 100 * error) : fmt::format("{:.2e}", error);
}

std::string step_in_words(double time_step)
{
    return time_step < 1 ? fmt::format("{:.4g} ms", 1e3 * time_step) : fmt::format("{:.6g} s", time_step);
}

std::string percent_in_words(double share)
{
    return share >= 0.995 ? fmt::format("{:.0f} %", 100 * share) : fmt::format("{:.2g} %", 100 * share);
}

std::string length_in_words(double metres)
{
    const double size = std::abs(metres);
    if (size == 0) return "0 mm";
    if (size < 5e-5) return fmt::format("{:.3g} µm", metres * 1e6);
    return size < 1 ? fmt::format("{:.3g} mm", metres * 1e3) : fmt::format("{:.3g} m", metres);
}

}  // namespace voussoir::app::words
