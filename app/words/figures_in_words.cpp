#include "app/words/figures_in_words.h"

#include <fmt/format.h>

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

}  // namespace voussoir::app::words
