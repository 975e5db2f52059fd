// A YAML document as a plain tree that remembers its lines; the one place that knows yaml-cpp.
#pragma once

#include <string>
#include <vector>

namespace voussoir::app::reader
{

struct YamlNode {
    enum class Kind { null, scalar, list, map };
    Kind kind = Kind::null;
    std::string text;               // of a scalar
    int line = 0;                   // 1-based
    std::string origin;             // "--set stages[1].time_step" if it came from the command line, else empty
    std::vector<YamlNode> items;    // of a list, or the values of a map
    std::vector<std::string> keys;  // of a map, beside items; a key written twice is here twice
};

/// Largest case file that is read, bytes; no honest one comes near.
constexpr std::size_t largest_case_file = std::size_t{16} << 20;

/// Parses one YAML document. Aliases, tags and second documents are refused, and so are more than a million nodes:
/// a small file must not become a large one.
/// @param name what faults are placed at: "arch.yaml" gives "arch.yaml:14"; @param with_lines false for one-liners
/// @throws InputError one fault: not text, or not YAML
YamlNode parse_yaml(const std::string& text, const std::string& name, bool with_lines = true);

/// "a list", "a map", "nothing", or the scalar's text in quotes (cut when long).
std::string describe(const YamlNode& node);

}  // namespace voussoir::app::reader
