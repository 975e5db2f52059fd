#include "app/report/bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/report/run_record.h"
#include "app/report/sections.h"
#include "app/words/figures_in_words.h"
#include "libdda/errors.h"

namespace voussoir::app::report
{
namespace
{

using Json = nlohmann::json;

constexpr std::array<const char*, 3> force_names = {"tension", "compression", "shear"};
constexpr std::array<const char*, 3> force_keys = {"largest_tension_N", "largest_compression_N",
                                                   "largest_shear_N"};
constexpr double slack_share = 1e-6;  // of the largest tension: what is left below it is none

/// The columns of the frames, as a file names them.
struct FrameColumns {
    std::vector<std::string> names;
    std::vector<double> values;  // (frames x bars x names)
    std::size_t bars = 0;

    double at(std::size_t frame, std::size_t bar, const char* name) const
    {
        const auto found = std::find(names.begin(), names.end(), name);
        const auto column = static_cast<std::size_t>(found - names.begin());
        const std::size_t place = (frame * bars + bar) * names.size() + column;
        return found == names.end() || place >= values.size() ? 0 : values[place];
    }
};

void follow(const FrameColumns& frames, std::size_t index, const std::vector<double>& times, BarCourse& bar)
{
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double tension = frames.at(i, index, "tension_N"), shear = frames.at(i, index, "shear_N");
        bar.tension.push_back(tension);
        bar.shear.push_back(shear);
        bar.force[0].see(tension, times[i]);
        bar.force[1].see(-tension, times[i]);
        bar.force[2].see(shear, times[i]);
        bar.elongation.see(frames.at(i, index, "elongation_m"), times[i]);
    }
    if (times.empty()) return;
    const std::size_t last = times.size() - 1;
    bar.last_force[0] = bar.tension.back();
    bar.last_force[1] = bar.shear.back();
    bar.last_elongation = frames.at(last, index, "elongation_m");
    bar.yielded = frames.at(last, index, "yielded_m");
}

/// The summary has the largest of every step, and of results of earlier versions all that is known.
void take_summary(const Json& of, bool has_frames, BarCourse& bar)
{
    for (std::size_t kind = 0; kind < force_keys.size(); ++kind)
        bar.force[kind].value = std::max(bar.force[kind].value, of.value(force_keys[kind], 0.0));
    const auto time = [&](const char* key) {
        return of.contains(key) && of.at(key).is_number() ? std::optional(of.at(key).get<double>()) : std::nullopt;
    };
    bar.yielded_since = time("yielded_time_s");
    bar.out_since = time("out_time_s");
    bar.yielded = of.value("yielded_m", bar.yielded);
    if (has_frames) return;
    bar.last_force[0] = of.value("tension_N", 0.0);
    bar.last_force[1] = of.value("shear_N", 0.0);
    bar.last_elongation = of.value("elongation_m", 0.0);
    for (Peak& peak : bar.force) peak.time = std::numeric_limits<double>::quiet_NaN();
    bar.elongation.time = std::numeric_limits<double>::quiet_NaN();
}

std::string kilonewtons(double newtons)
{
    return figure(newtons / 1e3);
}

std::string in_millimetres(double metres)
{
    return fmt::format("{:.3g}", 1e3 * metres);
}

std::string time_in_words(double time)
{
    return std::isnan(time) ? "not stored" : figure(time);
}

std::string elongation_in_words(const BarCourse& bar)
{
    return std::isnan(bar.elongation.time) ? "not stored" : in_millimetres(bar.elongation.value);
}

/// "yielded at 1.034 s, 37.6 mm longer for good", "slack", "out of its hole since 2 s".
std::string state_of(const BarCourse& bar)
{
    if (bar.out_since) return fmt::format("out of its hole since {:.4g} s", *bar.out_since);
    std::string state = "elastic";
    if (bar.yielded_since || bar.yielded > 0)
        state = fmt::format("yielded{}, {} for good",
                            bar.yielded_since ? fmt::format(" at {:.4g} s", *bar.yielded_since) : "",
                            words::length_in_words(bar.yielded));
    const bool slack =
        bar.is_rod && bar.force[0].value > 0 && bar.last_force[0] <= slack_share * bar.force[0].value;
    return slack ? state + "; slack at the end" : state;
}

std::string use_in_words(const BarCourse& bar)
{
    const std::optional<double> use = bar.use();
    return use ? fmt::format("{:.3g}", 100 * *use) : "no strength given";
}

const Peak& governing_force(const BarCourse& bar)
{
    return bar.force[static_cast<std::size_t>(bar.governing())];
}

}  // namespace

BarForce BarCourse::governing() const
{
    std::size_t most = 0;
    double share = -1;
    for (std::size_t kind = 0; kind < force_names.size(); ++kind) {
        if (!std::isfinite(strength[kind]) || !(strength[kind] > 0)) continue;
        if (force[kind].value / strength[kind] > share) most = kind, share = force[kind].value / strength[kind];
    }
    if (share >= 0) return static_cast<BarForce>(most);
    for (std::size_t kind = 1; kind < force_names.size(); ++kind)
        if (force[kind].value > force[most].value) most = kind;
    return static_cast<BarForce>(most);
}

std::optional<double> BarCourse::use() const
{
    const auto kind = static_cast<std::size_t>(governing());
    if (!std::isfinite(strength[kind]) || !(strength[kind] > 0)) return std::nullopt;
    return force[kind].value / strength[kind];
}

double BarCourse::when() const
{
    return yielded_since ? *yielded_since : force[static_cast<std::size_t>(governing())].time;
}

std::vector<BarCourse> bars_of(const results::Hdf5File& file, const std::vector<double>& times,
                               const std::string& summary)
{
    if (!file.has("/model/bars")) return {};
    const std::vector<std::string> names = file.read_texts("/model/bars/name");
    const auto blocks = file.read<std::int32_t>("/model/bars/blocks");
    const auto is_rod = file.read<std::int32_t>("/model/bars/is_rod");
    const auto springs = file.read<double>("/model/bars/springs");  // along, across, the strengths, prestress
    constexpr std::size_t columns = 6, first_strength = 2;
    if (blocks.size() != 2 * names.size() || is_rod.size() != names.size() ||
        springs.size() != columns * names.size())
        throw InputError("results", "bars without their blocks or springs",
                         "the file is damaged: run the case again");
    FrameColumns frames;
    frames.bars = names.size();
    const bool has_frames = file.has("/frames/bars");
    if (has_frames) {
        frames.names = file.texts_attribute("/frames/bars", "columns");
        frames.values = file.read<double>("/frames/bars");
    }
    const Json all = Json::parse(summary);
    std::vector<BarCourse> bars;
    for (std::size_t i = 0; i < names.size(); ++i) {
        BarCourse bar;
        bar.name = names[i];
        bar.block_a = blocks[2 * i];
        bar.block_b = blocks[2 * i + 1];
        bar.is_rod = is_rod[i] != 0;
        for (std::size_t kind = 0; kind < force_names.size(); ++kind)
            bar.strength[kind] = springs[columns * i + first_strength + kind];
        if (has_frames) follow(frames, i, times, bar);
        if (all.contains("bars") && i < all.at("bars").size()) take_summary(all.at("bars")[i], has_frames, bar);
        bars.push_back(std::move(bar));
    }
    return bars;
}

const char* name_of(BarForce force)
{
    return force_names.at(static_cast<std::size_t>(force));
}

std::vector<const BarCourse*> by_use(const std::vector<BarCourse>& bars)
{
    std::vector<const BarCourse*> order;
    order.reserve(bars.size());
    for (const BarCourse& bar : bars) order.push_back(&bar);
    std::stable_sort(order.begin(), order.end(), [](const BarCourse* a, const BarCourse* b) {
        return a->use().value_or(0) > b->use().value_or(0);
    });
    return order;
}

Section bars_section(const RunRecord& record)
{
    Section section{bars_title, {}, {}, {}, {}, {}};
    if (record.bars.empty()) return section;
    const auto yielded = std::count_if(record.bars.begin(), record.bars.end(),
                                       [](const BarCourse& bar) { return bar.yielded_since || bar.yielded > 0; });
    const auto out = std::count_if(record.bars.begin(), record.bars.end(),
                                   [](const BarCourse& bar) { return bar.out_since.has_value(); });
    section.paragraphs.push_back(fmt::format(
        "Bars: {}, of which {} yielded and {} left their holes. Forces are the largest of all steps; when "
        "they were is told to a stored moment, the first yielding to a step.",
        record.bars.size(), yielded, out));
    Table table{"bars",
                "Those first that came closest to yielding",
                {"bar", "between", "and", "tension [kN]", "compression [kN]", "shear [kN]",
                 "share of its strength [%]", "in", "at [s]", "elongation [mm]", "at the end [mm]", "left"},
                {}};
    const std::vector<std::string>& names = record.results.model.block_names;
    for (const BarCourse* bar : by_use(record.bars))
        table.rows.push_back({bar->name, names.at(static_cast<std::size_t>(bar->block_a)),
                              names.at(static_cast<std::size_t>(bar->block_b)), kilonewtons(bar->force[0].value),
                              kilonewtons(bar->force[1].value), kilonewtons(bar->force[2].value),
                              use_in_words(*bar), name_of(bar->governing()), time_in_words(bar->when()),
                              elongation_in_words(*bar), in_millimetres(bar->last_elongation), state_of(*bar)});
    table.shown = 15;
    section.tables.push_back(std::move(table));
    return section;
}

std::vector<std::string> bar_row(const RunRecord& record)
{
    if (record.bars.empty()) return {};
    const BarCourse& bar = *by_use(record.bars).front();
    const char* kind = name_of(bar.governing());
    const std::string force = fmt::format("{} kN of {}", kilonewtons(governing_force(bar).value), kind);
    const std::string share = bar.use() ? fmt::format(", {:.3g} % of its strength", 100 * *bar.use()) : "";
    const bool says_when = std::isnan(bar.when()) || bar.yielded_since;  // its state does
    const std::string when = says_when ? "" : fmt::format(" at t = {:.4g} s", bar.when());
    return {"bar that came closest to yielding", force + share + when + "; " + state_of(bar), bar.name};
}

Section bars_compared(const RunRecord& a, const RunRecord& b)
{
    Section section{bars_title, {}, {}, {}, {}, {}};
    Table table{
        "bars",
        "Bars that both have",
        {"bar", "tension A [kN]", "tension B [kN]", "shear A [kN]", "shear B [kN]", "share of its strength A [%]",
         "share of its strength B [%]", "elongation A [mm]", "elongation B [mm]", "left A", "left B"},
        {}};
    for (const BarCourse* one : by_use(a.bars)) {
        const auto other = std::find_if(b.bars.begin(), b.bars.end(),
                                        [&](const BarCourse& bar) { return bar.name == one->name; });
        if (other == b.bars.end()) continue;
        table.rows.push_back({one->name, kilonewtons(one->force[0].value), kilonewtons(other->force[0].value),
                              kilonewtons(one->force[2].value), kilonewtons(other->force[2].value),
                              use_in_words(*one), use_in_words(*other), elongation_in_words(*one),
                              elongation_in_words(*other), state_of(*one), state_of(*other)});
    }
    if (a.bars.empty() && b.bars.empty()) return section;
    section.paragraphs.push_back(
        fmt::format("Bars: {} in A, {} in B; {} in both.", a.bars.size(), b.bars.size(), table.rows.size()));
    table.shown = 15;
    if (!table.rows.empty()) section.tables.push_back(std::move(table));
    return section;
}

}  // namespace voussoir::app::report
