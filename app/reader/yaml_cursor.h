// Reading a YAML tree strictly: every value has a place, every fault is recorded and none thrown, and what nobody
// asked for is unknown.
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/reader/findings.h"
#include "app/reader/yaml_tree.h"
#include "app/words/quantity.h"

namespace voussoir::app::reader
{

/// A node of the tree and the path that led there. The map functions remember which keys were asked for;
/// reject_unknown_keys() reports the others. A value that cannot be used is a fault in the findings and comes back
/// as NaN (quantities), 0 or empty: nothing is built from a case with faults.
class YamlCursor
{
 public:
    YamlCursor(const YamlNode& node, std::string path, Findings& findings)
        : node_(&node), path_(std::move(path)), findings_(&findings)
    {
    }

    /// "arch.yaml:14: stages[1].time_step", or "--set stages[1].time_step".
    std::string place() const;
    const std::string& path() const { return path_; }
    bool is_scalar() const { return node_->kind == YamlNode::Kind::scalar; }
    bool is_list() const { return node_->kind == YamlNode::Kind::list; }
    bool is_map() const { return node_->kind == YamlNode::Kind::map; }
    /// Is it a list of `count` entries?
    bool is_list_of(std::size_t count) const { return is_list() && node_->items.size() == count; }
    /// The scalar's text, or "a list", "a map of keys", "nothing".
    std::string found() const { return describe(*node_); }

    void fault(std::string found, std::string expected) const;
    void warn(const std::string& text) const;
    /// Faults of the whole case so far: what is read between two counts is sound if they are equal.
    std::size_t fault_count() const { return findings_->faults.size(); }
    void took_default(const std::string& key, const std::string& value) const;

    // The value itself.
    bool expect_map(std::string_view what) const;  // a fault unless it is one
    /// The entries of a list; a fault, and none, unless it is a list. @param what "a list of stages"
    std::vector<YamlCursor> items(std::string_view what) const;
    /// The entries of a map whose keys are names the user chose; all count as asked for.
    std::vector<std::pair<std::string, YamlCursor>> named_entries(std::string_view what);
    std::string as_text() const;
    double as_quantity(const words::Dimension& dimension, const words::Range& range) const;
    Eigen::Vector3d as_vector(const words::Dimension& dimension) const;        // [x, y, z]
    Eigen::Vector2d as_plane_vector(const words::Dimension& dimension) const;  // [x, z]

    // Keys of a map. A key that was renamed is also found under its former name, with a warning; both are a fault.
    std::optional<YamlCursor> find(const std::string& key);
    std::optional<YamlCursor> require(const std::string& key, std::string_view what);  // a fault when missing
    /// A key that is known elsewhere but means nothing here.
    void forbid(const std::string& key, const std::string& why);
    void reject_unknown_keys() const;

    double quantity(const std::string& key, const words::Dimension& dimension, const words::Range& range);
    std::optional<double> find_quantity(const std::string& key, const words::Dimension& dimension,
                                        const words::Range& range);
    double quantity_or(const std::string& key, const words::Dimension& dimension, const words::Range& range,
                       double otherwise);
    int integer_or(const std::string& key, int lowest, int highest, int otherwise);
    bool boolean_or(const std::string& key, bool otherwise);
    std::string text(const std::string& key, std::string_view what);
    std::optional<std::string> find_text(const std::string& key);

    template <class Choice>
    using Choices = std::initializer_list<std::pair<std::string_view, Choice>>;
    template <class Choice>
    std::optional<Choice> find_choice(const std::string& key, Choices<Choice> choices);
    template <class Choice>
    Choice choice_or(const std::string& key, Choices<Choice> choices, Choice otherwise);

 private:
    YamlCursor child(const YamlNode& node, const std::string& key) const;
    template <int N>
    Eigen::Matrix<double, N, 1> as_components(const words::Dimension& dimension, std::string_view form) const;
    /// The value at a key as it is written; none when the node is no map.
    std::optional<YamlCursor> at(const std::string& key) const;
    std::optional<YamlCursor> find_former(const std::string& key, bool is_given);
    void report_duplicate(std::size_t first, std::size_t second) const;
    /// Index of the scalar at `key` among `names`; -1 with a fault when it is none; -2 when the key is absent.
    int find_word(const std::string& key, const std::vector<std::string>& names);

    const YamlNode* node_;
    std::string path_;
    Findings* findings_;
    std::vector<std::string> asked_, forbidden_;
};

template <class Choice>
std::optional<Choice> YamlCursor::find_choice(const std::string& key, Choices<Choice> choices)
{
    std::vector<std::string> names;
    for (const auto& [name, value] : choices) names.emplace_back(name);
    const int index = find_word(key, names);
    if (index == -2) return std::nullopt;
    return (choices.begin() + (index < 0 ? 0 : index))->second;
}

template <class Choice>
Choice YamlCursor::choice_or(const std::string& key, Choices<Choice> choices, Choice otherwise)
{
    const std::optional<Choice> chosen = find_choice(key, choices);
    if (chosen) return *chosen;
    for (const auto& [name, value] : choices)
        if (value == otherwise) took_default(key, std::string(name));
    return otherwise;
}

}  // namespace voussoir::app::reader
