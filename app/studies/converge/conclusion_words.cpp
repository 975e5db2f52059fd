// The conclusion of a study in words.
#include <fmt/format.h>

#include "app/results/settings.h"
#include "app/studies/converge/conclusion.h"
#include "app/studies/converge/verdict.h"
#include "app/words/figures_in_words.h"

namespace voussoir::app::studies::converge
{
namespace
{

std::string in_words(const KnownQuantity& known)
{
    if (!known.within && !known.value) return fmt::format("{}: not compared, {}", known.name, known.why_not);
    if (!known.within)
        return fmt::format("{} not known: {} in this run, {}", known.name, value_in_words(known.value, known.unit),
                           known.why_not);
    return fmt::format("{} {} +- {}", known.name, value_in_words(known.value, known.unit),
                       share_in_words(known.within));
}

std::string setting_in_words(const Conclusion& conclusion)
{
    const SeriesRow& row = *conclusion.row;
    std::string setting;
    if (!conclusion.is_static)
        setting =
            fmt::format("{}, {}", results::name_of(row.setting.integrator), words::step_in_words(row.time_step));
    if (conclusion.is_static || row.setting.stiffness_factor != 1)
        setting +=
            fmt::format("{}contact stiffness x {:g}", setting.empty() ? "" : ", ", row.setting.stiffness_factor);
    return fmt::format("{} ({:.3g} s CPU)", setting, row.cost.cpu());
}

}  // namespace

std::vector<std::string> in_words(const Conclusion& conclusion)
{
    const std::string wanted = fmt::format("wanted: {:g} %", 100 * conclusion.tolerance);
    if (!conclusion.row)
        return {"conclusion, " + wanted + ": no run gave a value to compare" +
                (conclusion.remarks.empty() ? "" : ", the first for this: " + conclusion.remarks.front())};
    std::vector<std::string> lines;
    lines.push_back(fmt::format("conclusion, {}: {} {}", wanted, setting_in_words(conclusion),
                                conclusion.meets ? "is the cheapest that meets it" : "is the best of these"));
    for (const KnownQuantity& known : conclusion.known) lines.push_back("  " + in_words(known));
    if (conclusion.case_lines.empty()) {
        lines.emplace_back("  the case has this setting already: nothing to change");
    } else {
        lines.emplace_back("  in the case file:");
        for (const std::string& line : conclusion.case_lines) lines.push_back("    " + line);
        std::string options = "  or for one run:";
        for (const std::string& option : conclusion.set_options) options += " --set \"" + option + "\"";
        lines.push_back(options);
    }
    for (const std::string& remark : conclusion.remarks) lines.push_back("  " + remark);
    if (!conclusion.joint_lines.empty()) lines.emplace_back("  for rigid joints, in the case file:");
    for (const std::string& line : conclusion.joint_lines) lines.push_back("    " + line);
    return lines;
}

}  // namespace voussoir::app::studies::converge
