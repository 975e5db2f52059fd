#include "app/studies/ensemble/variation.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "app/studies/converge/setting.h"
#include "libdda/errors.h"

namespace voussoir::app::studies::ensemble
{

namespace
{

/// The values between commas; those within brackets, braces and quotes belong to a value: [a.at2,b.at2,c.at2].
std::vector<std::string> values_in(const std::string& list)
{
    std::vector<std::string> values;
    std::string value;
    int depth = 0;
    char quote = 0;
    for (const char c : list) {
        if (quote != 0)
            quote = c == quote ? '\0' : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '[' || c == '{')
            ++depth;
        else if (c == ']' || c == '}')
            --depth;
        if (c == ',' && depth <= 0 && quote == 0)
            values.push_back(std::exchange(value, ""));
        else
            value += c;
    }
    if (!value.empty()) values.push_back(value);
    return values;
}

}  // namespace

Variation read_variation(const std::string& text)
{
    const auto refuse = [&](const std::string& found) {
        return InputError("--vary", "\"" + text + "\" " + found,
                          "write KEY=VALUE,VALUE,..., as blocks[0].house.imperfection.seed=1,2,3");
    };
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) throw refuse("names no key");
    Variation variation{text.substr(0, equals), values_in(text.substr(equals + 1))};
    const std::set<std::string> different(variation.values.begin(), variation.values.end());
    if (different.contains("")) throw refuse("has an empty value");
    if (different.size() != variation.values.size()) throw refuse("has a value twice");
    if (different.empty()) throw refuse("has no value");
    return variation;
}

namespace
{

std::vector<std::string> points_of(const Case& member)
{
    std::vector<std::string> names;
    for (const HistoryPoint& point : member.output.histories) names.push_back(point.name);
    return names;
}

/// Members have the same points and the same time step, which may be halved.
void expect_comparable(const Case& member, const Case& first)
{
    const StepControl &control = converge::first_dynamic_stage(member).control,
                      &other = converge::first_dynamic_stage(first).control;
    if (points_of(member) != points_of(first) || control.time_step != other.time_step ||
        member.stages.size() != first.stages.size())
        throw InputError(
            "--vary", "the members differ in their time step, stages or output.histories",
            "vary properties of the structure or of its motion; the time step is halved automatically");
    for (const Stage& stage : member.stages)
        if (stage.type == StageType::dynamic && 0.5 * stage.control.time_step < stage.control.min_time_step)
            throw InputError(member.file.string() + ": stages",
                             "half the time_step of '" + stage.name + "' is below its min_time_step",
                             "lower the min_time_step");
}

/// Steps that are left to the program are the same in all members: the shortest of theirs.
void share_automatic_steps(std::vector<Case>& members)
{
    const auto is_alike = [&](const Case& member) {
        return member.stages.size() == members.front().stages.size();
    };
    if (!std::all_of(members.begin(), members.end(), is_alike)) return;
    for (std::size_t s = 0; s < members.front().stages.size(); ++s) {
        double shortest = std::numeric_limits<double>::infinity();
        for (const Case& member : members) shortest = std::min(shortest, member.stages[s].control.time_step);
        for (Case& member : members)
            if (StepControl& control = member.stages[s].control; control.automatic) control.time_step = shortest;
    }
}

}  // namespace

std::vector<Case> read_members(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                               const Variation& variation, const CaseReader& read)
{
    std::vector<Case> members;
    for (const std::string& value : variation.values) {
        std::vector<std::string> settings = overrides;
        settings.push_back(variation.key + "=" + value);
        members.push_back(read(file, settings));
    }
    share_automatic_steps(members);
    for (const Case& member : members) expect_comparable(member, members.front());
    if (members.front().output.histories.empty())
        throw InputError(file.string() + ": output.histories", "there is no point whose drift could be compared",
                         "name some, such as histories: {top: {block: NAME}}");
    return members;
}

}  // namespace voussoir::app::studies::ensemble
