#include "records/synthetic/target_spectrum.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libdda/errors.h"
#include "libdda/text/numbers.h"
#include "records/units.h"

namespace voussoir::records::synthetic
{

namespace
{

/// Soil factor and the corner periods [s] of one row of the tables.
struct Row {
    double soil, b, c, d;
};

Row row_of(const Eurocode8& p)
{
    constexpr Row type_1[] = {{1.0, 0.15, 0.4, 2.0},
                              {1.2, 0.15, 0.5, 2.0},
                              {1.15, 0.20, 0.6, 2.0},
                              {1.35, 0.20, 0.8, 2.0},
                              {1.4, 0.15, 0.5, 2.0}};
    constexpr Row type_2[] = {{1.0, 0.05, 0.25, 1.2},
                              {1.35, 0.05, 0.25, 1.2},
                              {1.5, 0.10, 0.25, 1.2},
                              {1.8, 0.10, 0.30, 1.2},
                              {1.6, 0.05, 0.25, 1.2}};
    if (p.vertical) return {1.0, 0.05, 0.15, 1.0};
    return p.type == 1 ? type_1[p.ground - 'A'] : type_2[p.ground - 'A'];
}

void check(const Eurocode8& p)
{
    std::vector<Fault> faults;
    if (p.type != 1 && p.type != 2)
        faults.push_back({"eurocode_8: type", std::to_string(p.type), "must be 1 or 2"});
    if (p.ground < 'A' || p.ground > 'E')
        faults.push_back({"eurocode_8: ground", std::string(1, p.ground), "must be A, B, C, D or E"});
    if (!(p.acceleration > 0) || !std::isfinite(p.acceleration))
        faults.push_back({"eurocode_8: acceleration [m/s2]", text::to_text(p.acceleration), "must be > 0"});
    if (!(p.damping > 0 && p.damping < 1))
        faults.push_back({"eurocode_8: damping", text::to_text(p.damping), "must be a ratio > 0 and < 1"});
    if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace

TargetSpectrum eurocode_8(const Eurocode8& p)
{
    check(p);
    const Row row = row_of(p);
    const double share = !p.vertical ? 1 : p.type == 1 ? 0.9 : 0.45;
    const double eta = std::max(std::sqrt(10 / (5 + 100 * p.damping)), 0.55);
    const double ground = p.acceleration * share * row.soil;
    const double amplification = eta * (p.vertical ? 3.0 : 2.5);
    TargetSpectrum target;
    target.name = "Eurocode 8 type " + std::to_string(p.type) +
                  (p.vertical ? ", vertical, " : std::string(", ground ") + p.ground + ", ") +
                  text::to_text(p.acceleration / standard_gravity) + " g";
    target.damping = p.damping;
    target.at = [=](double period) {
        if (period < row.b) return ground * (1 + period / row.b * (amplification - 1));
        const double plateau = ground * amplification;
        if (period < row.c) return plateau;
        if (period < row.d) return plateau * row.c / period;
        return plateau * row.c * row.d / (period * period);
    };
    return target;
}

TargetSpectrum tabulated_spectrum(std::string name, std::vector<double> periods, std::vector<double> accelerations,
                                  double damping)
{
    std::vector<Fault> faults;
    if (periods.size() < 2 || periods.size() != accelerations.size())
        faults.push_back({name, std::to_string(periods.size()) + " points", "a spectrum needs at least 2"});
    for (std::size_t i = 0; i < std::min(periods.size(), accelerations.size()); ++i) {
        const bool ascends =
            periods[i] >= 0 && (i == 0 || periods[i] > periods[i - 1]) && std::isfinite(periods[i]);
        if (!ascends)
            faults.push_back(
                {name, "period " + text::to_text(periods[i]) + " s", "periods must be > 0 and ascending"});
        if (!(accelerations[i] > 0) || !std::isfinite(accelerations[i]))
            faults.push_back({name, "acceleration " + text::to_text(accelerations[i]) + " m/s2", "must be > 0"});
    }
    if (!(damping > 0 && damping < 1))
        faults.push_back({name, "damping " + text::to_text(damping), "must be > 0 and < 1"});
    if (!faults.empty()) throw InputError(std::move(faults));
    TargetSpectrum target{std::move(name), damping, {}, periods.front(), periods.back()};
    target.at = [periods = std::move(periods), accelerations = std::move(accelerations)](double period) {
        const auto after = std::upper_bound(periods.begin() + 1, periods.end() - 1, period) - periods.begin();
        const double share = (period - periods[after - 1]) / (periods[after] - periods[after - 1]);
        return std::lerp(accelerations[after - 1], accelerations[after], std::clamp(share, 0.0, 1.0));
    };
    return target;
}

}  // namespace voussoir::records::synthetic
