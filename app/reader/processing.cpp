#include "app/reader/processing.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "app/reader/wave.h"
#include "app/words/nearest_word.h"
#include "libdda/errors.h"

namespace voussoir::app::reader
{
namespace
{

using std::numbers::pi;

/// A quantity that is a length of time or a fraction: `2 s` or `5 %`.
bool is_fraction(const YamlCursor& value)
{
    return value.found().find('%') != std::string::npos;
}

records::processing::ProcessingStep read_window(YamlCursor& map)
{
    if (!map.expect_map("{from: 10 s, to: 30 s} or {arias: [0.1 %, 99 %]}"))
        return records::processing::TimeWindow{};
    const std::optional<YamlCursor> fractions = map.find("arias");
    if (!fractions) {
        records::processing::TimeWindow window;
        window.start = map.quantity_or("from", words::dimension::time, words::Range::any(), 0);
        if (const auto end = map.find_quantity("to", words::dimension::time, words::Range::positive()))
            window.end = *end;
        map.reject_unknown_keys();
        return window;
    }
    records::processing::AriasWindow window;
    const std::vector<YamlCursor> pair = fractions->items("two fractions, [0.1 %, 99 %]");
    if (pair.size() == 2) {
        window.from = pair[0].as_quantity(words::dimension::number, words::Range::any());
        window.to = pair[1].as_quantity(words::dimension::number, words::Range::any());
    } else {
        fractions->fault(std::to_string(pair.size()) + " entries", "write two fractions, [0.1 %, 99 %]");
    }
    window.lead = map.quantity_or("lead", words::dimension::time, words::Range::any(), 0);
    if (const auto longest = map.find_quantity("longest", words::dimension::time, words::Range::positive()))
        window.longest = *longest;
    map.reject_unknown_keys();
    return window;
}

records::processing::ProcessingStep read_taper(const YamlCursor& value)
{
    records::processing::Taper taper;
    if (is_fraction(value))
        taper.fraction = value.as_quantity(words::dimension::number, words::Range::positive());
    else
        taper.seconds = value.as_quantity(words::dimension::time, words::Range::positive());
    return taper;
}

records::processing::ProcessingStep read_filter(YamlCursor& map, bool has_low, bool has_high)
{
    records::processing::Butterworth filter;
    if (!map.expect_map("{low: 0.1 Hz, high: 25 Hz, order: 4}")) return filter;
    if (has_low) filter.low_corner = map.quantity("low", words::dimension::frequency, words::Range::positive());
    if (has_high) filter.high_corner = map.quantity("high", words::dimension::frequency, words::Range::positive());
    filter.order = map.integer_or("order", 1, 10, filter.order);
    filter.zero_phase = !(map.find("causal") && map.boolean_or("causal", false));
    map.reject_unknown_keys();
    return filter;
}

records::processing::ProcessingStep read_scale_to_spectrum(YamlCursor& map)
{
    records::processing::ScaleToSpectrum scale;
    if (!map.expect_map("{period: 0.5 s, acceleration: 0.4 g}")) return scale;
    scale.period = map.quantity("period", words::dimension::time, words::Range::positive());
    scale.value = map.quantity("acceleration", words::dimension::acceleration, words::Range::positive());
    scale.damping = map.quantity_or("damping", words::dimension::number, words::Range::positive(), scale.damping);
    scale.component = map.find_text("component").value_or("");
    map.reject_unknown_keys();
    return scale;
}

/// `0.3 g`, or `{value: 0.3 g, component: NS}`.
records::processing::ProcessingStep read_scale_to_peak(YamlCursor& value, records::Quantity peak)
{
    const words::Dimension& what =
        peak == records::Quantity::acceleration ? words::dimension::acceleration : words::dimension::peak_velocity;
    records::processing::ScaleToPeak scale;
    scale.peak = peak;
    if (!value.is_map()) {
        scale.value = value.as_quantity(what, words::Range::positive());
        return scale;
    }
    scale.value = value.quantity("value", what, words::Range::positive());
    scale.component = value.find_text("component").value_or("");
    value.reject_unknown_keys();
    return scale;
}

records::processing::ProcessingStep read_rotate(YamlCursor& map)
{
    records::processing::Rotate rotate;
    if (!map.expect_map("{x_azimuth: 30 deg}")) return rotate;
    rotate.x_azimuth = map.quantity("x_azimuth", words::dimension::angle, words::Range::any()) * 180 / pi;
    map.reject_unknown_keys();
    return rotate;
}

records::processing::ProcessingStep read_match(YamlCursor& map)
{
    records::processing::Match match;
    if (!map.expect_map("{target: {eurocode_8: {...}}}")) return match;
    match.settings.shortest =
        map.quantity_or("shortest", words::dimension::time, words::Range::positive(), match.settings.shortest);
    match.settings.longest =
        map.quantity_or("longest", words::dimension::time, words::Range::positive(), match.settings.longest);
    if (std::optional<YamlCursor> target = map.require("target", "the spectrum to match"))
        if (std::optional<records::synthetic::TargetSpectrum> spectrum = read_target_spectrum(*target))
            match.target = *spectrum;
    map.reject_unknown_keys();
    return match;
}

records::processing::ProcessingStep read_integral(const YamlCursor& value, bool up)
{
    const std::string word = value.as_text();
    const std::vector<std::string> words = up ? std::vector<std::string>{"velocity", "displacement"}
                                              : std::vector<std::string>{"velocity", "acceleration"};
    if (word != words[0] && word != words[1])
        value.fault("\"" + word + "\"", "write " + words[0] + " or " + words[1]);
    if (up)
        return records::processing::Integrate{word == "displacement" ? records::Quantity::displacement
                                                                     : records::Quantity::velocity};
    return records::processing::Differentiate{word == "velocity" ? records::Quantity::velocity
                                                                 : records::Quantity::acceleration};
}

records::processing::ProcessingStep read_baseline(const YamlCursor& value)
{
    const double order = value.as_quantity(words::dimension::number, words::Range::any());
    return records::processing::RemoveBaseline{
        order >= 0 && order <= 100 && order == std::floor(order) ? static_cast<int>(order) : -1};
}

struct StepReader {
    std::string key;
    std::function<records::processing::ProcessingStep(YamlCursor&)> read;
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
         [](YamlCursor& value) {
             return records::processing::Resample{
                 value.as_quantity(words::dimension::time, words::Range::positive())};
         }},
        {"scale",
         [](YamlCursor& value) {
             return records::processing::Scale{value.as_quantity(words::dimension::number, words::Range::any())};
         }},
        {"scale_to_pga",
         [](YamlCursor& value) { return read_scale_to_peak(value, records::Quantity::acceleration); }},
        {"scale_to_pgv", [](YamlCursor& value) { return read_scale_to_peak(value, records::Quantity::velocity); }},
        {"scale_to_spectrum", read_scale_to_spectrum},
        {"rotate", read_rotate},
        {"match", read_match},
        {"integrate", [](YamlCursor& value) { return read_integral(value, true); }},
        {"differentiate", [](YamlCursor& value) { return read_integral(value, false); }},
    };
    return readers;
}

std::optional<records::processing::ProcessingStep> read_word(const YamlCursor& item)
{
    const std::string word = item.as_text();
    if (word == "mean") return records::processing::RemoveMean{};
    if (word == "end_correction") return records::processing::CorrectEnd{};
    std::vector<std::string> words{"mean", "end_correction"};
    for (const StepReader& reader : step_readers()) {
        words.push_back(reader.key);
        if (word != reader.key) continue;
        item.fault("step " + word + " without figures", "write {" + word + ": ...}");
        return std::nullopt;
    }
    if (!word.empty()) item.fault("step \"" + word + "\"", words::suggestion(word, words));
    return std::nullopt;
}

std::optional<records::processing::ProcessingStep> read_step(YamlCursor& item)
{
    if (item.is_scalar()) return read_word(item);
    if (!item.expect_map("a step: mean, end_correction, {window: ...} or similar")) return std::nullopt;
    std::optional<records::processing::ProcessingStep> step;
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

records::processing::Processing read_processing_steps(const YamlCursor& list)
{
    records::processing::Processing steps;
    for (YamlCursor& item : list.items("a list of steps, [mean, {taper: 1 s}]"))
        if (std::optional<records::processing::ProcessingStep> step = read_step(item))
            steps.push_back(std::move(*step));
    return steps;
}

records::processing::Processing parse_processing_steps(const std::string& text, const std::string& option)
{
    Findings findings;
    const YamlNode tree = parse_yaml(text, option, false);
    records::processing::Processing steps = read_processing_steps(YamlCursor(tree, option, findings));
    if (!findings.faults.empty()) throw InputError(std::move(findings.faults));
    return steps;
}

}  // namespace voussoir::app::reader
