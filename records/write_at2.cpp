#include "records/write_at2.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "libdda/errors.h"
#include "libdda/text/numbers.h"
#include "records/units.h"

namespace voussoir::records
{

namespace
{

constexpr std::size_t field_width = 16;
constexpr std::size_t samples_per_line = 5;

/// "  -1.2345678E-02": eight significant digits, the same in every locale.
std::string field(double value)
{
    std::array<char, 32> buffer{};
    const auto result =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific, 7);
    std::string text(buffer.data(), result.ptr);
    const std::size_t exponent = text.find('e');
    if (exponent != std::string::npos) text[exponent] = 'E';
    return std::string(field_width - std::min(text.size(), field_width), ' ') + text;
}

}  // namespace

std::string format_at2(const std::string& first_title, const std::string& second_title, const Channel& channel)
{
    DDA_ASSERT(channel.quantity == Quantity::acceleration);
    std::string text = first_title + "\n" + second_title + "\n" + "ACCELERATION TIME SERIES IN UNITS OF G\n" +
                       "NPTS= " + std::to_string(channel.samples.size()) +
                       ", DT= " + text::to_text(channel.time_step) + " SEC\n";
    for (std::size_t i = 0; i < channel.samples.size(); ++i) {
        text += field(channel.samples[i] / standard_gravity);
        const bool line_ends = (i + 1) % samples_per_line == 0 || i + 1 == channel.samples.size();
        if (line_ends) text += '\n';
    }
    return text;
}

}  // namespace voussoir::records
