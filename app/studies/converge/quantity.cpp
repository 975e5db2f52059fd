#include "app/studies/converge/quantity.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "app/words/nearest_word.h"
#include "libdda/errors.h"
#include "libdda/model/kinematics.h"

namespace voussoir::app::studies::converge
{
namespace
{

constexpr std::string_view largest = "largest";
constexpr std::array<std::string_view, 3> measures{"history", "peak", "end"};
constexpr std::array<std::string_view, 3> fields{"u", "d", "v"};
constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

/// "crown.dx", without the measure.
std::string followed(const Quantity& quantity, const Case& the_case)
{
    if (quantity.field == Field::largest_drift) return std::string(largest);
    std::string name = the_case.output.histories[quantity.point].name + ".";
    name += fields[static_cast<int>(quantity.field)];
    if (quantity.component >= 0) name += axes[quantity.component];
    return name;
}

/// Everything that can be followed in a case.
std::vector<Quantity> all_followed(const Case& the_case)
{
    std::vector<Quantity> all;
    for (int point = 0; point < static_cast<int>(the_case.output.histories.size()); ++point)
        for (const Field field : {Field::drift, Field::displacement, Field::velocity}) {
            all.push_back({field, point, -1});
            for (const int component : axes_of(the_case.model.kinematics))
                all.push_back({field, point, component});
        }
    all.push_back({});
    return all;
}

std::vector<Quantity> default_quantities(const Case& the_case)
{
    std::vector<Quantity> chosen;
    for (const Quantity& each : all_followed(the_case))
        if (each.field == Field::drift && each.component < 0) chosen.push_back(each);
    if (!chosen.empty()) return chosen;
    for (const Measure measure : {Measure::peak, Measure::end}) {
        chosen.emplace_back();
        chosen.back().measure = measure;
    }
    return chosen;
}

std::optional<Measure> measure_named(std::string_view word)
{
    const auto found = std::find(measures.begin(), measures.end(), word);
    if (found == measures.end()) return std::nullopt;
    return static_cast<Measure>(found - measures.begin());
}

/// The quantity a word means, or nothing with a fault.
std::optional<Quantity> read_word(const std::string& word, const Case& the_case, std::vector<Fault>& faults)
{
    const std::size_t colon = word.rfind(':');
    const std::string what = word.substr(0, colon);
    const std::string how(colon == std::string::npos ? measures[0] : std::string_view(word).substr(colon + 1));
    const std::optional<Measure> measure = measure_named(how);
    if (!measure) {
        faults.push_back({"--quantity " + word, "there is no measure \"" + how + "\"",
                          words::suggestion(how, {measures.begin(), measures.end()})});
        return std::nullopt;
    }
    std::vector<std::string> known;
    for (Quantity each : all_followed(the_case)) {
        known.push_back(followed(each, the_case));
        each.measure = *measure;
        if (known.back() == what) return each;
    }
    faults.push_back(
        {"--quantity " + word, "there is no quantity \"" + what + "\"", words::suggestion(what, known)});
    return std::nullopt;
}

}  // namespace

std::string name_of(const Quantity& quantity, const Case& the_case)
{
    return followed(quantity, the_case) + ":" + std::string(measures[static_cast<int>(quantity.measure)]);
}

std::string unit_of(const Quantity& quantity)
{
    return quantity.field == Field::velocity ? "m/s" : "m";
}

std::vector<Quantity> read_quantities(const std::vector<std::string>& words, const Case& the_case)
{
    std::vector<Quantity> chosen;
    std::vector<Fault> faults;
    for (const std::string& word : words)
        if (const std::optional<Quantity> quantity = read_word(word, the_case, faults))
            if (std::find(chosen.begin(), chosen.end(), *quantity) == chosen.end()) chosen.push_back(*quantity);
    if (!faults.empty()) throw InputError(std::move(faults));
    if (words.empty()) chosen = default_quantities(the_case);
    for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i].channel = static_cast<int>(i);
    return chosen;
}

}  // namespace voussoir::app::studies::converge
