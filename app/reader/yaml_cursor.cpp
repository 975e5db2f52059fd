#include "app/reader/yaml_cursor.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <unordered_map>
#include <utility>

#include "app/reader/asked_keys.h"
#include "app/reader/renamed_keys.h"
#include "app/words/nearest_word.h"

namespace voussoir::app::reader
{
namespace
{
constexpr std::size_t max_faults = 1000;  // nobody reads more, and a hostile file has a million

bool contains(const std::vector<std::string>& words, const std::string& word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}
}  // namespace

std::string YamlCursor::place() const
{
    std::string where = node_->origin.empty() ? fmt::format("{}:{}", findings_->file, node_->line) : node_->origin;
    // "--set a.b" already names a.b; only what lies deeper in its value needs the path.
    if (path_.empty() || where == "--set " + path_) return where;
    return where + ": " + path_;
}

void YamlCursor::fault(std::string found, std::string expected) const
{
    findings_->faults.push_back({place(), std::move(found), std::move(expected)});
    if (findings_->faults.size() < max_faults) return;
    std::vector<Fault> faults = findings_->faults;
    faults.push_back({findings_->file, "too many faults; reading stopped here", "correct those above first"});
    throw InputError(std::move(faults));
}

void YamlCursor::warn(const std::string& text) const
{
    findings_->warnings.push_back(place() + ": " + text);
}

void YamlCursor::took_default(const std::string& key, const std::string& value) const
{
    findings_->defaults.push_back({path_, key, value});
}

YamlCursor YamlCursor::child(const YamlNode& node, const std::string& key) const
{
    return {node, path_.empty() || key.front() == '[' ? path_ + key : path_ + "." + key, *findings_};
}

bool YamlCursor::expect_map(std::string_view what) const
{
    if (!is_map()) fault(found(), fmt::format("expected {}", what));
    return is_map();
}

std::vector<YamlCursor> YamlCursor::items(std::string_view what) const
{
    std::vector<YamlCursor> cursors;
    if (!is_list()) {
        fault(found(), fmt::format("expected {}", what));
        return cursors;
    }
    for (std::size_t i = 0; i < node_->items.size(); ++i)
        cursors.push_back(child(node_->items[i], fmt::format("[{}]", i)));
    return cursors;
}

std::vector<std::pair<std::string, YamlCursor>> YamlCursor::named_entries(std::string_view what)
{
    std::vector<std::pair<std::string, YamlCursor>> entries;
    if (!expect_map(what)) return entries;
    std::unordered_map<std::string_view, std::size_t> known;
    for (std::size_t i = 0; i < node_->keys.size(); ++i) {
        const auto [first, is_new] = known.emplace(node_->keys[i], i);
        if (!is_new) {
            report_duplicate(first->second, i);
        } else if (node_->keys[i].empty()) {
            child(node_->items[i], "\"\"").fault("an empty name", "give it a name");
        } else {
            entries.emplace_back(node_->keys[i], child(node_->items[i], node_->keys[i]));
        }
    }
    return entries;
}

void YamlCursor::report_duplicate(std::size_t first, std::size_t second) const
{
    child(node_->items[second], node_->keys[second].empty() ? "\"\"" : node_->keys[second])
        .fault(fmt::format("given twice (first in line {})", node_->items[first].line), "keep one of them");
}

std::string YamlCursor::as_text() const
{
    if (is_scalar() && !node_->text.empty()) return node_->text;
    fault(is_scalar() ? "an empty text" : found(), "expected a text");
    return {};
}

double YamlCursor::as_quantity(const words::Dimension& dimension, const words::Range& range) const
{
    constexpr double unusable = std::numeric_limits<double>::quiet_NaN();
    const std::string expected = fmt::format("expected {} such as {}", dimension.name, dimension.example);
    if (!is_scalar()) {
        fault(found(), expected);
        return unusable;
    }
    const words::ParsedQuantity quantity = words::parse_quantity(node_->text);
    if (!quantity.problem.empty()) {
        fault(found() + ": " + quantity.problem, expected);
    } else if (words::lacks_unit(quantity, dimension)) {
        fault(found() + " has no unit", words::with_units(node_->text, dimension));
    } else if (!quantity.bare && !quantity.has(dimension)) {
        fault(found() + " has the wrong dimension", expected);
    } else if (!range.contains(quantity.value)) {
        fault(quantity.bare ? words::in_words(quantity.value, dimension) : node_->text,
              words::in_words(range, dimension));
    } else {
        return quantity.value;
    }
    return unusable;
}

template <int N>
Eigen::Matrix<double, N, 1> YamlCursor::as_components(const words::Dimension& dimension,
                                                      std::string_view form) const
{
    using Vector = Eigen::Matrix<double, N, 1>;
    Vector vector = Vector::Constant(std::numeric_limits<double>::quiet_NaN());
    if (!is_list_of(N)) {
        fault(is_list() ? fmt::format("a list of {}", node_->items.size()) : found(),
              fmt::format("expected {}", form));
        return vector;
    }
    for (int i = 0; i < N; ++i)
        vector[i] = child(node_->items[i], fmt::format("[{}]", i)).as_quantity(dimension, words::Range::any());
    return vector;
}

Eigen::Vector3d YamlCursor::as_vector(const words::Dimension& dimension) const
{
    return as_components<3>(dimension, "three components [x, y, z]");
}

Eigen::Vector2d YamlCursor::as_plane_vector(const words::Dimension& dimension) const
{
    return as_components<2>(dimension, "two components [x, z]");
}

std::optional<YamlCursor> YamlCursor::find(const std::string& key)
{
    if (!contains(asked_, key)) asked_.push_back(key);
    if (asked_keys != nullptr) asked_keys->keys[path_].insert(key);
    const std::optional<YamlCursor> value = at(key);
    const std::optional<YamlCursor> former = find_former(key, value.has_value());
    return value ? value : former;
}

std::optional<YamlCursor> YamlCursor::at(const std::string& key) const
{
    if (!is_map()) return std::nullopt;
    const auto place = std::find(node_->keys.begin(), node_->keys.end(), key);
    if (place == node_->keys.end()) return std::nullopt;
    return child(node_->items[place - node_->keys.begin()], key);
}

/// The value under the name that the key had in the release before, if it is used.
std::optional<YamlCursor> YamlCursor::find_former(const std::string& key, bool is_given)
{
    const std::string name(former_name(key));
    const std::optional<YamlCursor> former = name.empty() ? std::nullopt : at(name);
    if (!former) return std::nullopt;
    forbidden_.push_back(name);  // known, but not a word to suggest
    if (is_given) {
        former->fault(fmt::format("the former name of {}, which is given too", key), "keep " + key);
    } else if (!contains(findings_->former_keys, name)) {
        findings_->former_keys.push_back(name);
        former->warn(
            fmt::format("this key is now called {}; the former name is accepted in this release only", key));
    }
    return former;
}

std::optional<YamlCursor> YamlCursor::require(const std::string& key, std::string_view what)
{
    std::optional<YamlCursor> value = find(key);
    if (!value && is_map()) child(*node_, key).fault("missing", fmt::format("give {}", what));
    return value;
}

void YamlCursor::forbid(const std::string& key, const std::string& why)
{
    AskedKeys* const notes = std::exchange(asked_keys, nullptr);
    if (const std::optional<YamlCursor> value = find(key)) value->fault("has no meaning here", why);
    asked_keys = notes;
    std::erase(asked_, key);  // not a word to suggest
    forbidden_.push_back(key);
}

void YamlCursor::reject_unknown_keys() const
{
    std::unordered_map<std::string_view, std::size_t> known;
    for (std::size_t i = 0; i < node_->keys.size(); ++i) {
        const std::string& key = node_->keys[i];
        const auto [first, is_new] = known.emplace(key, i);
        if (!is_new) {
            report_duplicate(first->second, i);
        } else if (!contains(asked_, key) && !contains(forbidden_, key)) {
            child(node_->items[i], key.empty() ? "\"\"" : key)
                .fault("unknown key", words::suggestion(key, asked_));
        }
    }
}

double YamlCursor::quantity(const std::string& key, const words::Dimension& dimension, const words::Range& range)
{
    const auto value = require(key, fmt::format("{} such as {}", dimension.name, dimension.example));
    return value ? value->as_quantity(dimension, range) : std::numeric_limits<double>::quiet_NaN();
}

std::optional<double> YamlCursor::find_quantity(const std::string& key, const words::Dimension& dimension,
                                                const words::Range& range)
{
    const std::optional<YamlCursor> value = find(key);
    if (!value) return std::nullopt;
    return value->as_quantity(dimension, range);
}

double YamlCursor::quantity_or(const std::string& key, const words::Dimension& dimension,
                               const words::Range& range, double otherwise)
{
    const std::optional<double> value = find_quantity(key, dimension, range);
    if (!value) took_default(key, words::in_words(otherwise, dimension));
    return value.value_or(otherwise);
}

int YamlCursor::integer_or(const std::string& key, int lowest, int highest, int otherwise)
{
    const std::optional<YamlCursor> value = find(key);
    if (!value) {
        took_default(key, std::to_string(otherwise));
        return otherwise;
    }
    int number = 0;
    const std::string& text = value->node_->text;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (!value->is_scalar() || error != std::errc{} || end != text.data() + text.size() || number < lowest ||
        number > highest) {
        value->fault(value->found(), fmt::format("expected a whole number from {} to {}", lowest, highest));
        return otherwise;
    }
    return number;
}

bool YamlCursor::boolean_or(const std::string& key, bool otherwise)
{
    return choice_or<bool>(key, {{"true", true}, {"false", false}}, otherwise);
}

std::string YamlCursor::text(const std::string& key, std::string_view what)
{
    const std::optional<YamlCursor> value = require(key, what);
    return value ? value->as_text() : std::string();
}

std::optional<std::string> YamlCursor::find_text(const std::string& key)
{
    const std::optional<YamlCursor> value = find(key);
    if (!value) return std::nullopt;
    return value->as_text();
}

int YamlCursor::find_word(const std::string& key, const std::vector<std::string>& names)
{
    const std::optional<YamlCursor> value = find(key);
    if (!value) return -2;
    if (asked_keys != nullptr) asked_keys->words[value->path_].insert(names.begin(), names.end());
    if (value->is_scalar()) {
        const auto at = std::find(names.begin(), names.end(), value->node_->text);
        if (at != names.end()) return static_cast<int>(at - names.begin());
    }
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    const std::string near = value->is_scalar() ? words::nearest_word(value->node_->text, names) : "";
    value->fault(value->found(), "expected one of " + list + (near.empty() ? "" : "; did you mean " + near + "?"));
    return -1;
}

}  // namespace voussoir::app::reader
