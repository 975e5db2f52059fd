#include "app/studies/converge/threshold.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "libdda/errors.h"
#include "libdda/text/words.h"

namespace voussoir::app::studies::converge
{
namespace
{

constexpr std::string_view between = "..";

/// A number and what follows it. @returns false when there is no number
bool split_number(std::string_view text, double& number, std::string& unit)
{
    text = text::trim(text);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || !std::isfinite(number)) return false;
    text.remove_prefix(end - text.data());
    unit = text::trim(text);
    return true;
}

std::string written(const Threshold& threshold, double value)
{
    return fmt::format("{}{}{}", value, threshold.unit.empty() ? "" : " ", threshold.unit);
}

/// Where the structure still stands and where it has collapsed, at one setting.
struct Bracket {
    double stands, collapses;
    RunCost cost;
    std::string failure;

    double middle() const { return (stands + collapses) / 2; }
    double width() const { return std::abs(collapses - stands); }
};

class Bisection
{
 public:
    Bisection(const Case& base, const Threshold& threshold, const CollapseRule& rule, int threads,
              const ConvergeWatch& watch, const CaseReader& read)
        : base_(base), threshold_(threshold), rule_(rule), threads_(threads), watch_(watch), read_(read)
    {
    }

    Bracket at(const ConvergeSetting& setting) const
    {
        Bracket bracket{threshold_.stands, threshold_.collapses, {}, {}};
        if (collapses(setting, bracket.stands, bracket))
            fail(bracket, fmt::format("collapses already at {}", in_words(bracket.stands)));
        if (bracket.failure.empty() && !collapses(setting, bracket.collapses, bracket))
            fail(bracket, fmt::format("still stands at {}", in_words(bracket.collapses)));
        while (bracket.failure.empty() && !settled(bracket)) {
            const double middle = bracket.middle();
            (collapses(setting, middle, bracket) ? bracket.collapses : bracket.stands) = middle;
        }
        return bracket;
    }

 private:
    /// A run that gave up has said why already.
    static void fail(Bracket& bracket, const std::string& reason)
    {
        if (bracket.failure.empty()) bracket.failure = reason;
    }
    std::string in_words(double value) const { return threshold_.key + " = " + written(threshold_, value); }
    /// Narrow enough: as a share of its middle, or, where that is next to 0, of a share of where it began.
    bool settled(const Bracket& bracket) const
    {
        const double least = threshold_.bracket * std::abs(threshold_.collapses - threshold_.stands);
        const bool divisible = bracket.middle() != bracket.stands && bracket.middle() != bracket.collapses;
        return !divisible || bracket.width() <= threshold_.bracket * std::max(std::abs(bracket.middle()), least);
    }
    bool collapses(const ConvergeSetting& setting, double value, Bracket& bracket) const
    {
        std::vector<std::string> overrides = base_.overrides;
        for (std::string& setting : settings_of(threshold_, value)) overrides.push_back(std::move(setting));
        Case the_case = read_(base_.file, overrides);
        for (Stage& stage : the_case.stages) stage.control.threads = threads_;
        const MeasuredRun run = run_setting(the_case, setting, {}, rule_, watch_);
        bracket.cost += run.cost;
        if (!run.failure.empty()) fail(bracket, in_words(value) + ": " + run.failure);
        return run.collapse || run.collapsed;
    }

    const Case& base_;
    const Threshold& threshold_;
    const CollapseRule& rule_;
    int threads_;
    const ConvergeWatch& watch_;
    const CaseReader& read_;
};

Series judged(const Case& the_case, const SeriesPlan& plan, const SettingList& list,
              const std::vector<Bracket>& brackets)
{
    Series series;
    series.varied = plan.varied;
    series.integrator = plan.integrator;
    series.is_static = leading_stage(the_case).type != StageType::dynamic;
    std::vector<std::optional<Sample>> samples;
    double resolution = 0;
    for (const std::size_t index : plan.settings) {
        const Bracket& bracket = brackets[index];
        series.rows.push_back(row_of(list.settings[index], the_case, bracket.cost, bracket.failure));
        samples.emplace_back();
        if (!bracket.failure.empty()) continue;
        samples.back() = Sample::Constant(1, 1, bracket.middle());
        resolution = std::max(resolution, bracket.width());
    }
    judge(series, samples, resolution, [](const Sample& sample) { return sample(0, 0); });
    return series;
}

}  // namespace

Threshold read_threshold(const std::string& text)
{
    Threshold threshold;
    const std::size_t equals = text.find('='), dots = text.find(between, equals);
    std::string unit_before;
    const bool read = equals != std::string::npos && equals > 0 && dots != std::string::npos &&
                      split_number(text.substr(equals + 1, dots - equals - 1), threshold.stands, unit_before) &&
                      split_number(text.substr(dots + between.size()), threshold.collapses, threshold.unit);
    const std::string place = "--threshold " + text;
    if (!read)
        throw InputError(place, "not a threshold",
                         "write KEY=STANDS..COLLAPSES, as in foundation.motion.x.scale=1..3");
    if (!unit_before.empty() && unit_before != threshold.unit)
        throw InputError(place, "two units", "write both values in the same unit, as in 0.1 g..0.5 g");
    if (threshold.stands == threshold.collapses)
        throw InputError(place, "the two values are the same",
                         "give one at which it stands, one at which it collapses");
    threshold.key = text.substr(0, equals);
    for (std::size_t from = 0; from <= threshold.key.size();) {
        const std::size_t comma = std::min(threshold.key.find(',', from), threshold.key.size());
        threshold.keys.emplace_back(text::trim(std::string_view(threshold.key).substr(from, comma - from)));
        if (threshold.keys.back().empty())
            throw InputError(place, "a key is missing between commas", "write KEY,KEY=STANDS..COLLAPSES");
        from = comma + 1;
    }
    return threshold;
}

std::vector<std::string> settings_of(const Threshold& threshold, double value)
{
    std::vector<std::string> settings;
    for (const std::string& key : threshold.keys) settings.push_back(key + "=" + written(threshold, value));
    return settings;
}

ConvergeStudy run_threshold_study(const Case& the_case, const SettingList& list, const Threshold& threshold,
                                  const CollapseRule& rule, int threads, const ConvergeWatch& watch,
                                  const CaseReader& read)
{
    const Bisection bisection(the_case, threshold, rule, threads, watch, read);
    std::vector<Bracket> brackets;
    for (const ConvergeSetting& setting : list.settings) brackets.push_back(bisection.at(setting));
    ConvergeStudy study = begin_study(the_case, rule);
    study.may_be_ensemble = false;
    study.quantities.push_back({"threshold of " + threshold.key, threshold.unit, {}, {}});
    for (const SeriesPlan& plan : list.series)
        study.quantities.back().series.push_back(judged(the_case, plan, list, brackets));
    study.notes.push_back(
        fmt::format("thresholds are midpoints of brackets of {:g} %; beyond the first collapse a structure may "
                    "stand again, which bisection does not detect",
                    100 * threshold.bracket));
    return study;
}

}  // namespace voussoir::app::studies::converge
