#include "app/case/processing.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "app/case/nearest_word.h"
#include "app/case/wave.h"
#include "libdda/errors.h"

namespace voussoir
{
namespace
{

using std::numbers::pi;

/// A quantity that is a length of time or a fraction: `2 s` or `5 %`.
bool is_fraction(const YamlCursor& value)
{
    return value.found().find('%') != std::string::npos;
}

ProcessingStep read_window(YamlCursor& map)
{
    if (!map.expect_map("{from: 10 s, to: 30 s} or {arias: [0.1 %, 99 %]}")) return TimeWindow{};
    const std::optional<YamlCursor> fractions = map.find("arias");
    if (!fractions) {
        TimeWindow window;
        window.start = map.quantity_or("from", dimension::time, Range::any(), 0);
        if (const auto end = map.find_quantity("to", dimension::time, Range::positive())) window.end = *end;
        map.reject_unknown_keys();
        return window;
    }
    AriasWindow window;
    const std::vector<YamlCursor> pair = fractions->items("two fractions, [0.1 %, 99 %]");
    if (pair.size() == 2) {
        window.from = pair[0].as_quantity(dimension::number, Range::any());
        window.to = pair[1].as_quantity(dimension::number, Range::any());
    } else {
        fractions->fault(std::to_string(pair.size()) + " entries", "write two fractions, [0.1 %, 99 %]");
    }
    window.lead = map.quantity_or("lead", dimension::time, Range::any(), 0);
    if (const auto longest = map.find_quantity("longest", dimension::time, Range::positive()))
        window.longest = *longest;
    map.reject_unknown_keys();
    return window;
}

ProcessingStep read_taper(const YamlCursor& value)
{
    Taper taper;
    if (is_fraction(value))
        taper.fraction = value.as_quantity(dimension::number, Range::positive());
    else
        taper.seconds = value.as_quantity(dimension::time, Range::positive());
    return taper;
}

ProcessingStep read_filter(YamlCursor& map, bool has_low, bool has_high)
{
    Butterworth filter;
    if (!map.expect_map("{low: 0.1 Hz, high: 25 Hz, order: 4}")) return filter;
    if (has_low) filter.low_corner = map.quantity("low", dimension::frequency, Range::positive());
    if (has_high) filter.high_corner = map.quantity("high", dimension::frequency, Range::positive());
    filter.order = map.integer_or("order", 1, 10, filter.order);
    filter.zero_phase = !(map.find("causal") && map.boolean_or("causal", false));
    map.reject_unknown_keys();
    return filter;
}

ProcessingStep read_scale_to_spectrum(YamlCursor& map)
{
    ScaleToSpectrum scale;
    if (!map.expect_map("{period: 0.5 s, acceleration: 0.4 g}")) return scale;
    scale.period = map.quantity("period", dimension::time, Range::positive());
    scale.value = map.quantity("acceleration", dimension::acceleration, Range::positive());
    scale.damping = map.quantity_or("damping", dimension::number, Range::positive(), scale.damping);
    scale.component = map.find_text("component").value_or("");
    map.reject_unknown_keys();
    return scale;
}

/// `0.3 g`, or `{value: 0.3 g, component: NS}`.
ProcessingStep read_scale_to_peak(YamlCursor& value, Quantity peak)
{
    const Dimension& what = peak == Quantity::acceleration ? dimension::acceleration : dimension::velocity;
    ScaleToPeak scale;
    scale.peak = peak;
    if (!value.is_map()) {
        scale.value = value.as_quantity(what, Range::positive());
        return scale;
    }
    scale.value = value.quantity("value", what, Range::positive());
    scale.component = value.find_text("component").value_or("");
    value.reject_unknown_keys();
    return scale;
}

ProcessingStep read_rotate(YamlCursor& map)
{
    Rotate rotate;
    if (!map.expect_map("{x_azimuth: 30 deg}")) return rotate;
    rotate.x_azimuth = map.quantity("x_azimuth", dimension::angle, Range::any()) * 180 / pi;
    map.reject_unknown_keys();
    return rotate;
}

ProcessingStep read_match(YamlCursor& map)
{
    Match match;
    if (!map.expect_map("{target: {eurocode_8: {...}}}")) return match;
    match.settings.shortest =
        map.quantity_or("shortest", dimension::time, Range::positive(), match.settings.shortest);
    match.settings.longest =
        map.quantity_or("longest", dimension::time, Range::positive(), match.settings.longest);
    if (std::optional<YamlCursor> target = map.require("target", "the spectrum to match"))
        if (std::optional<TargetSpectrum> spectrum = read_target_spectrum(*target)) match.target = *spectrum;
    map.reject_unknown_keys();
    return match;
}

ProcessingStep read_integral(const YamlCursor& value, bool up)
{
    const std::string word = value.as_text();
    const std::vector<std::string> words = up ? std::vector<std::string>{"velocity", "displacement"}
                                              : std::vector<std::string>{"velocity", "acceleration"};
    if (word != words[0] && word != words[1])
        value.fault("\"" + word + "\"", "write " + words[0] + " or " + words[1]);
    if (up) return Integrate{word == "displacement" ? Quantity::displacement : Quantity::velocity};
    return Differentiate{word == "velocity" ? Quantity::velocity : Quantity::acceleration};
}

ProcessingStep read_baseline(const YamlCursor& value)
{
    const double order = value.as_quantity(dimension::number, Range::any());
    return RemoveBaseline{order >= 0 && order <= 100 && order == std::floor(order) ? static_cast<int>(order) : -1};
}

struct StepReader {
    std::string key;
    std::function<ProcessingStep(YamlCursor&)> read;
};

const std::vector<StepReader>& step_readers()
{
    static const std::vector<StepReader> readers{
        {"window", read_window},
        {"baseline", read_baseline},
        {"taper", read_taper},
        {"band_pass", [](YamlCursor& map) { return read_filter(map, true, true); }},
        {"high_pass", [](YamlCursor& map) { return read_filter(map, true, false); }},
        {"low_pass", [](YamlCursor& map) { return read_filter(map, false, true); }},
        {"resample",
         [](YamlCursor& value) { return Resample{value.as_quantity(dimension::time, Range::positive())}; }},
        {"scale", [](YamlCursor& value) { return Scale{value.as_quantity(dimension::number, Range::any())}; }},
        {"scale_to_pga", [](YamlCursor& value) { return read_scale_to_peak(value, Quantity::acceleration); }},
        {"scale_to_pgv", [](YamlCursor& value) { return read_scale_to_peak(value, Quantity::velocity); }},
        {"scale_to_spectrum", read_scale_to_spectrum},
        {"rotate", read_rotate},
        {"match", read_match},
        {"integrate", [](YamlCursor& value) { return read_integral(value, true); }},
        {"differentiate", [](YamlCursor& value) { return read_integral(value, false); }},
    };
    return readers;
}

std::optional<ProcessingStep> read_word(const YamlCursor& item)
{
    const std::string word = item.as_text();
    if (word == "mean") return RemoveMean{};
    if (word == "end_correction") return CorrectEnd{};
    std::vector<std::string> words{"mean", "end_correction"};
    for (const StepReader& reader : step_readers()) {
        words.push_back(reader.key);
        if (word != reader.key) continue;
        item.fault("step " + word + " without figures", "write {" + word + ": ...}");
        return std::nullopt;
    }
    if (!word.empty()) item.fault("step \"" + word + "\"", suggestion(word, words));
    return std::nullopt;
}

std::optional<ProcessingStep> read_step(YamlCursor& item)
{
    if (item.is_scalar()) return read_word(item);
    if (!item.expect_map("a step: mean, end_correction, {window: ...} or similar")) return std::nullopt;
    std::optional<ProcessingStep> step;
    for (const StepReader& reader : step_readers()) {
        std::optional<YamlCursor> value = item.find(reader.key);
        if (!value) continue;
        if (step) item.fault("two steps in one entry", "write each as a separate entry: the order matters");
        step = reader.read(*value);
    }
    for (const char* word : {"mean", "end_correction"})
        item.forbid(word, "write it as a single word, without parameters");
    item.reject_unknown_keys();
    return step;
}

}  // namespace

Processing read_processing_steps(const YamlCursor& list)
{
    Processing steps;
    for (YamlCursor& item : list.items("a list of steps, [mean, {taper: 1 s}]"))
        if (std::optional<ProcessingStep> step = read_step(item)) steps.push_back(std::move(*step));
    return steps;
}

Processing parse_processing_steps(const std::string& text, const std::string& option)
{
    Findings findings;
    const YamlNode tree = parse_yaml(text, option, false);
    Processing steps = read_processing_steps(YamlCursor(tree, option, findings));
    if (!findings.faults.empty()) throw InputError(std::move(findings.faults));
    return steps;
}

}  // namespace voussoir
