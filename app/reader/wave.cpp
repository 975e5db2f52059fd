#include "app/reader/wave.h"

#include <algorithm>
#include <cmath>

#include "libdda/errors.h"
#include "records/synthetic/noise.h"
#include "records/synthetic/waves.h"

namespace voussoir::app::reader
{
namespace
{

double acceleration_in(YamlCursor& map)
{
    return map.quantity("acceleration", words::dimension::acceleration, words::Range::any());
}
double frequency_in(YamlCursor& map, const char* key = "frequency")
{
    return map.quantity(key, words::dimension::frequency, words::Range::positive());
}
double duration_in(YamlCursor& map)
{
    return map.quantity("duration", words::dimension::time, words::Range::positive());
}

records::synthetic::Wave read_ramped_sine(YamlCursor& map)
{
    records::synthetic::RampedSine wave;
    wave.amplitude = acceleration_in(map);
    wave.frequency = frequency_in(map);
    wave.phase = map.quantity_or("phase", words::dimension::angle, words::Range::any(), 0);
    wave.ramp = map.quantity("ramp", words::dimension::time, words::Range::positive());
    wave.duration = duration_in(map);
    return wave;
}

records::synthetic::Wave read_sweep(YamlCursor& map)
{
    records::synthetic::Sweep wave;
    wave.amplitude = acceleration_in(map);
    wave.from = frequency_in(map, "from");
    wave.to = frequency_in(map, "to");
    wave.duration = duration_in(map);
    wave.logarithmic = map.choice_or<bool>("spacing", {{"linear", false}, {"logarithmic", true}}, false);
    return wave;
}

records::synthetic::Wave read_ricker(YamlCursor& map)
{
    records::synthetic::Ricker wave;
    wave.amplitude = acceleration_in(map);
    wave.frequency = frequency_in(map);
    wave.delay = map.quantity_or("delay", words::dimension::time, words::Range::positive(), 1.5 / wave.frequency);
    return wave;
}

records::synthetic::Wave read_pulse(YamlCursor& map)
{
    records::synthetic::OneCycle wave;
    wave.amplitude = acceleration_in(map);
    wave.period = map.quantity("period", words::dimension::time, words::Range::positive());
    wave.shape = map.choice_or<records::synthetic::OneCycle::Shape>(
        "shape",
        {{"sine", records::synthetic::OneCycle::Shape::sine},
         {"cosine", records::synthetic::OneCycle::Shape::cosine}},
        records::synthetic::OneCycle::Shape::sine);
    return wave;
}

bool is_finite(const records::synthetic::Wave& wave)
{
    return std::isfinite(records::synthetic::duration_of(wave)) &&
           std::isfinite(records::synthetic::highest_frequency_of(wave)) &&
           std::isfinite(records::synthetic::acceleration_of(wave, 0.25 * records::synthetic::duration_of(wave)));
}

std::optional<records::Channel> sample_wave(const records::synthetic::Wave& wave, YamlCursor& map,
                                            std::string& description)
{
    const double step = map.quantity_or("time_step", words::dimension::time, words::Range::positive(),
                                        records::synthetic::default_time_step(wave));
    map.reject_unknown_keys();
    if (!is_finite(wave) || !std::isfinite(step)) return std::nullopt;
    description += records::synthetic::in_words(wave);
    return records::synthetic::sampled(wave, step);
}

std::optional<records::Channel> read_noise(YamlCursor& map, std::string& description)
{
    records::synthetic::SyntheticMotion noise;
    noise.peak_acceleration =
        map.quantity("acceleration", words::dimension::acceleration, words::Range::positive());
    noise.duration = duration_in(map);
    noise.time_step =
        map.quantity_or("time_step", words::dimension::time, words::Range::positive(), noise.time_step);
    noise.seed = static_cast<std::uint64_t>(map.integer_or("seed", 0, 1'000'000'000, 1));
    noise.ground_frequency = map.quantity_or("ground_frequency", words::dimension::frequency,
                                             words::Range::positive(), noise.ground_frequency);
    noise.ground_damping = map.quantity_or("ground_damping", words::dimension::number, words::Range::positive(),
                                           noise.ground_damping);
    noise.high_pass_frequency = map.quantity_or("high_pass", words::dimension::frequency, words::Range::positive(),
                                                noise.high_pass_frequency);
    map.reject_unknown_keys();
    if (!std::isfinite(noise.peak_acceleration + noise.duration + noise.time_step + noise.ground_frequency +
                       noise.ground_damping + noise.high_pass_frequency))
        return std::nullopt;
    description += "filtered noise, seed " + std::to_string(noise.seed);
    records::Channel channel;
    channel.time_step = noise.time_step;
    channel.samples = records::synthetic::synthetic_acceleration(noise);
    channel.unit_in_file = "m/s2";
    return channel;
}

std::optional<records::synthetic::TargetSpectrum> read_eurocode(YamlCursor& map)
{
    records::synthetic::Eurocode8 code;
    if (!map.expect_map("{type: 1, ground: B, acceleration: 0.25 g}")) return std::nullopt;
    code.type = map.integer_or("type", 1, 2, 1);
    code.vertical = map.find("vertical") && map.boolean_or("vertical", false);
    if (!code.vertical)
        code.ground =
            map.choice_or<char>("ground", {{"A", 'A'}, {"B", 'B'}, {"C", 'C'}, {"D", 'D'}, {"E", 'E'}}, 'A');
    code.acceleration = map.quantity("acceleration", words::dimension::acceleration, words::Range::positive());
    code.damping = map.quantity_or("damping", words::dimension::number, words::Range::positive(), code.damping);
    map.reject_unknown_keys();
    if (!std::isfinite(code.acceleration + code.damping)) return std::nullopt;
    return records::synthetic::eurocode_8(code);
}

std::optional<records::synthetic::TargetSpectrum> read_table(const YamlCursor& list, double damping)
{
    std::vector<double> periods, accelerations;
    for (const YamlCursor& point : list.items("a list of [period, acceleration]")) {
        const std::vector<YamlCursor> pair = point.items("[period, acceleration]");
        if (pair.size() != 2) {
            point.fault(std::to_string(pair.size()) + " entries", "write [period, acceleration]");
            continue;
        }
        periods.push_back(pair[0].as_quantity(words::dimension::time, words::Range::any()));
        accelerations.push_back(pair[1].as_quantity(words::dimension::acceleration, words::Range::positive()));
    }
    for (std::size_t i = 0; i < periods.size(); ++i)
        if (!std::isfinite(periods[i] + accelerations[i])) return std::nullopt;
    return records::synthetic::tabulated_spectrum("table", std::move(periods), std::move(accelerations), damping);
}

std::optional<records::Channel> read_parameters(const std::string& key, YamlCursor& value,
                                                std::string& description)
{
    if (key == "ramped_sine") return sample_wave(read_ramped_sine(value), value, description);
    if (key == "sweep") return sample_wave(read_sweep(value), value, description);
    if (key == "ricker") return sample_wave(read_ricker(value), value, description);
    if (key == "pulse") return sample_wave(read_pulse(value), value, description);
    return read_noise(value, description);
}

}  // namespace

const std::vector<std::string>& wave_keys()
{
    static const std::vector<std::string> keys{"ramped_sine", "sweep", "ricker", "pulse", "noise"};
    return keys;
}

std::optional<records::Channel> read_wave(const std::string& key, YamlCursor& value, std::string& description)
{
    if (!value.expect_map("the parameters of a " + key)) return std::nullopt;
    const std::size_t faults = value.fault_count();
    try {
        std::optional<records::Channel> wave = read_parameters(key, value, description);
        if (!wave && value.fault_count() == faults)
            value.fault("figures so large that the wave has no finite ones",
                        "give those of a ground motion, such as 2 Hz");
        return wave;
    } catch (const InputError& error) {
        for (const Fault& fault : error.faults) value.fault(fault.place + " = " + fault.found, fault.expected);
    }
    return std::nullopt;
}

std::optional<records::synthetic::TargetSpectrum> read_target_spectrum(YamlCursor& map)
{
    if (!map.expect_map("a target {eurocode_8: {...}} or {table: [...]}")) return std::nullopt;
    std::optional<YamlCursor> code = map.find("eurocode_8"), table = map.find("table");
    const double damping =
        table ? map.quantity_or("damping", words::dimension::number, words::Range::positive(), 0.05) : 0.05;
    map.reject_unknown_keys();
    if (code.has_value() == table.has_value()) {
        map.fault(code ? "two targets" : "no target", "give eurocode_8 or table");
        return std::nullopt;
    }
    try {
        return code ? read_eurocode(*code) : read_table(*table, damping);
    } catch (const InputError& error) {
        for (const Fault& fault : error.faults) map.fault(fault.place + ": " + fault.found, fault.expected);
    }
    return std::nullopt;
}

}  // namespace voussoir::app::reader
