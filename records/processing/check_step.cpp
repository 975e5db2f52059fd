// Parameters that are wrong for any record.

#include <cmath>

#include "records/processing/steps.h"

namespace voussoir::records::processing
{

namespace
{

/// Collects the faults of one step.
struct Check {
    std::string place;
    std::vector<Fault>& faults;

    void require(bool good, const char* name, const std::string& found, const char* expected) const
    {
        if (!good) faults.push_back({place, std::string(name) + " = " + found, expected});
    }
    void require(bool good, const char* name, double found, const char* expected) const
    {
        require(good, name, figure(found), expected);
    }
    void positive(const char* name, double value) const
    {
        require(value > 0 && std::isfinite(value), name, value, "must be finite and > 0");
    }

    void operator()(const TimeWindow& step) const
    {
        require(step.start >= 0 && std::isfinite(step.start), "start [s]", step.start, "must be finite and >= 0");
        require(step.end > step.start, "end [s]", step.end, "must be later than the start");
    }
    void operator()(const AriasWindow& step) const
    {
        require(step.from >= 0 && step.from < 1, "from", step.from, "must be a fraction from 0 to below 1");
        require(step.to > step.from && step.to <= 1, "to", step.to,
                "must be a fraction above `from` and at most 1");
        require(step.lead >= 0 && std::isfinite(step.lead), "lead [s]", step.lead, "must be finite and >= 0");
        require(step.longest > 0, "longest [s]", step.longest, "must be > 0");
    }
    void operator()(const RemoveBaseline& step) const
    {
        require(step.order >= 0 && step.order <= 6, "order", step.order, "must be 0 to 6");
    }
    void operator()(const Taper& step) const
    {
        if (step.seconds) positive("seconds", *step.seconds);
        if (step.fraction)
            require(*step.fraction > 0 && *step.fraction <= 0.5, "fraction", *step.fraction,
                    "must be > 0 and <= 0.5");
        require(step.seconds.has_value() != step.fraction.has_value(), "taper",
                step.seconds ? "both seconds and a fraction" : "no length", "give either seconds or a fraction");
    }
    void operator()(const Butterworth& step) const
    {
        require(step.order >= 1 && step.order <= 10, "order", step.order, "must be 1 to 10");
        if (step.low_corner) positive("low corner [Hz]", *step.low_corner);
        if (step.high_corner) positive("high corner [Hz]", *step.high_corner);
        require(step.low_corner || step.high_corner, "filter", "no corner",
                "give a low corner, a high one, or both");
        if (step.low_corner && step.high_corner)
            require(*step.low_corner < *step.high_corner, "high corner [Hz]", *step.high_corner,
                    "must be above the low corner");
    }
    void operator()(const Resample& step) const { positive("time step [s]", step.time_step); }
    void operator()(const Scale& step) const
    {
        require(step.factor != 0 && std::isfinite(step.factor), "factor", step.factor, "must be finite and not 0");
    }
    void operator()(const ScaleToPeak& step) const
    {
        positive("value", step.value);
        require(step.peak != Quantity::displacement, "peak", "displacement", "must be acceleration or velocity");
    }
    void operator()(const ScaleToSpectrum& step) const
    {
        positive("value [m/s2]", step.value);
        positive("period [s]", step.period);
        require(step.damping >= 0 && std::isfinite(step.damping), "damping", step.damping,
                "must be finite and >= 0");
    }
    void operator()(const Rotate& step) const
    {
        require(std::isfinite(step.x_azimuth), "azimuth of x [deg]", step.x_azimuth, "must be finite");
    }
    void operator()(const Integrate& step) const
    {
        require(step.to != Quantity::acceleration, "to", "acceleration", "must be velocity or displacement");
    }
    void operator()(const Differentiate& step) const
    {
        require(step.to != Quantity::displacement, "to", "displacement", "must be velocity or acceleration");
    }
    void operator()(const Match& step) const
    {
        require(static_cast<bool>(step.target.at), "target", "none", "give a target spectrum");
        positive("shortest period [s]", step.settings.shortest);
        require(step.settings.longest > step.settings.shortest, "longest period [s]", step.settings.longest,
                "must be longer than the shortest");
    }
    void operator()(const RemoveMean&) const {}
    void operator()(const CorrectEnd&) const {}
};

}  // namespace

void check_step(const ProcessingStep& step, const std::string& place, std::vector<Fault>& faults)
{
    std::visit(Check{place, faults}, step);
}

}  // namespace voussoir::records::processing
