#include "importers/patterns/parameter_checks.h"

#include <cmath>
#include <numbers>
#include <sstream>

#include "importers/patterns/circular_arc.h"
#include "importers/patterns/max_blocks.h"

namespace voussoir::importers::patterns
{
namespace
{

std::string in_words(double value, const char* unit = " m")
{
    std::ostringstream text;
    text << value << unit;
    return text.str();
}

/// Adds a fault unless lowest <= value < limit; NaN is neither.
void check_range(const char* name, double value, double limit, const std::string& expected,
                 std::vector<Fault>& faults, const char* unit = " m")
{
    if (!(value >= 0 && value < limit)) faults.push_back({name, in_words(value, unit), expected});
}

}  // namespace

void check_positive(const std::string& name, double value, std::vector<Fault>& faults)
{
    if (!std::isfinite(value) || value <= 0) faults.push_back({name, in_words(value), "must be > 0 m"});
}

void check_number(const std::string& name, int value, int least, std::vector<Fault>& faults)
{
    constexpr int most = 9999;
    if (value < least || value > most)
        faults.push_back(
            {name, std::to_string(value), "must be " + std::to_string(least) + " to " + std::to_string(most)});
}

void check_stones(const std::string& name, double stones, std::vector<Fault>& faults)
{
    if (stones > static_cast<double>(max_blocks))
        faults.push_back(
            {name, "more than " + std::to_string(max_blocks) + " stones", "give fewer courses or stones"});
}

std::string in_degrees(double angle)
{
    return in_words(angle * 180 / std::numbers::pi, " deg");
}

void check_arc(double span, double rise, std::vector<Fault>& faults)
{
    check_positive("span", span, faults);
    if (!(rise > 0 && rise <= span / 2))
        faults.push_back({"rise", in_words(rise), "must be > 0 m and at most half the span"});
}

void check_survey(const Survey& survey, std::vector<Fault>& faults)
{
    check_range("warp", survey.warp, 0.2, "must be >= 0 and < 20 %", faults, "");
    check_range("noise", survey.noise, 0.1, "must be >= 0 and < 10 %", faults, "");
}

void check_block(const BlockFormat& block, double longest, double height, double walls, std::vector<Fault>& faults)
{
    const std::size_t before = faults.size();
    check_positive("block", block.length, faults);
    check_positive("block", block.height, faults);
    if (faults.size() > before) return;
    if (block.length > longest)
        faults.push_back({"block", "a block " + in_words(block.length) + " long in a wall of " + in_words(longest),
                          "the block must fit into the wall"});
    if (block.height > height)
        faults.push_back({"block", "a block " + in_words(block.height) + " high in a wall of " + in_words(height),
                          "the block must fit into the wall"});
    if (walls * (longest / block.length) * (height / block.height) > static_cast<double>(max_blocks))
        faults.push_back({"block", "more than " + std::to_string(max_blocks) + " blocks",
                          "give a larger block or a smaller wall"});
}

void check_lintel_size(const Lintel& lintel, std::vector<Fault>& faults)
{
    check_positive("lintel.height", lintel.height, faults);
    check_positive("lintel.bearing", lintel.bearing, faults);
}

void check_base(const MasonryBase& base, std::vector<Fault>& faults)
{
    check_range("base.height", base.height, INFINITY, "must be >= 0 m", faults);
    check_range("base.projection", base.projection, INFINITY, "must be >= 0 m", faults);
}

void check_imperfection(const Imperfection& imperfection, double thickness, std::vector<Fault>& faults)
{
    check_range("imperfection.size", imperfection.size, 0.5, "must be >= 0 and < 50 %", faults, "");
    check_range("imperfection.joint", imperfection.joint, thickness / 4,
                "must be >= 0 m and less than a quarter of the thickness of the wall or leaf", faults);
    check_range("imperfection.friction", imperfection.friction, 1, "must be >= 0 and < 100 %", faults, "");
}

void check_placement(const Placement& placement, std::vector<Fault>& faults)
{
    if (!placement.origin.allFinite()) faults.push_back({"origin", "not finite", "three lengths in m"});
    if (!std::isfinite(placement.direction)) faults.push_back({"direction", "not finite", "an angle in rad"});
}

}  // namespace voussoir::importers::patterns
