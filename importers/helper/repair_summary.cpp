#include "importers/helper/repair_summary.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace voussoir::importers::helper
{

namespace
{

void add(const mesh::Repair& repair, const std::string& stone, std::vector<RepairSummary>& summaries)
{
    const auto same = [&](const RepairSummary& one) {
        return !repair.kind.empty() && one.kind == repair.kind && (one.stones > 0) == !stone.empty();
    };
    auto found = std::find_if(summaries.begin(), summaries.end(), same);
    const bool first = found == summaries.end();
    if (first)
        found = summaries.insert(summaries.end(), {repair.kind, 0, 0, 0, repair.counted, 0, repair.unit, "", ""});
    found->stones += !stone.empty();
    ++found->repairs;
    found->count += repair.count;
    if (!first && repair.worst <= found->worst) return;
    found->worst = repair.worst;
    found->worst_stone = stone;
    found->text = repair.text;
}

}  // namespace

std::vector<RepairSummary> summarised_repairs(const ImportedMesh& mesh)
{
    std::vector<RepairSummary> summaries;
    for (const mesh::Repair& repair : mesh.repairs) add(repair, "", summaries);
    for (const Stone& stone : mesh.stones)
        for (const mesh::Repair& repair : stone.repairs) add(repair, stone.name, summaries);
    return summaries;
}

std::string in_words(const RepairSummary& summary)
{
    if (summary.repairs == 1)
        return (summary.worst_stone.empty() ? "" : summary.worst_stone + ": ") + summary.text;
    std::string words = summary.kind + ": ";
    words += summary.stones > 0 ? std::to_string(summary.stones) + " stones"
                                : std::to_string(summary.repairs) + " times in the file";
    if (!summary.counted.empty()) words += ", " + std::to_string(summary.count) + " " + summary.counted;
    if (summary.worst > 0) words += ", at most " + short_number(summary.worst) + " " + summary.unit;
    if (summary.worst > 0 && !summary.worst_stone.empty()) words += " (" + summary.worst_stone + ")";
    return words;
}

std::vector<std::string> skipped_in_words(const ImportedMesh& mesh)
{
    constexpr std::size_t told = 5;
    const std::array<const char*, 3> keys{"skip", "only", "skip_types"};
    std::vector<std::pair<std::string, std::vector<std::string>>> groups;  // by key, in their first order
    for (const SkippedStone& stone : mesh.skipped) {
        const bool by_name = std::find(keys.begin(), keys.end(), stone.why) != keys.end();
        const std::string key = by_name ? stone.why : "repair: skip, for they would be refused";
        auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& one) { return one.first == key; });
        if (group == groups.end()) group = groups.insert(groups.end(), {key, {}});
        group->second.push_back(stone.name);
    }
    std::vector<std::string> lines;
    for (const auto& [key, names] : groups) {
        std::string line = std::to_string(names.size()) + (names.size() == 1 ? " stone was" : " stones were") +
                           " left out (" + key + "): ";
        for (std::size_t i = 0; i < std::min(told, names.size()); ++i) line += (i > 0 ? ", " : "") + names[i];
        if (names.size() > told) line += " and " + std::to_string(names.size() - told) + " others";
        lines.push_back(std::move(line));
    }
    return lines;
}

std::vector<std::string> all_repairs(const ImportedMesh& mesh)
{
    std::vector<std::string> lines;
    for (const mesh::Repair& repair : mesh.repairs) lines.push_back(repair.text);
    for (const Stone& stone : mesh.stones)
        for (const mesh::Repair& repair : stone.repairs) lines.push_back(stone.name + ": " + repair.text);
    for (const SkippedStone& stone : mesh.skipped) lines.push_back(stone.name + ": left out: " + stone.why);
    return lines;
}

std::string short_number(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value);  // NOLINT: the pattern is a literal
    return text.data();
}

std::vector<std::string> in_words(const JointFit& fit)
{
    std::vector<std::string> lines;
    if (fit.joints > 0)
        lines.push_back(std::to_string(fit.joints) + " joints did not fit as drawn, by up to " +
                        short_number(fit.misfit_before) +
                        " m, and got one surface for both sides; now they fit to " +
                        short_number(fit.misfit_after) + " m");
    if (fit.left > 0)
        lines.push_back(std::to_string(fit.left) +
                        " joints do not fit and were left as drawn: a side of them is too far from a plane");
    return lines;
}

}  // namespace voussoir::importers::helper
