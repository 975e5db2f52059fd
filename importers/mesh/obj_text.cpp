#include "importers/mesh/obj_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <system_error>

#include "libdda/errors.h"

namespace voussoir
{

namespace
{

constexpr std::size_t numbers_per_row = std::size_t{1}
                                        << 20;  // far below 2^24, where 32-bit numbers lose integers
constexpr std::size_t most_faults = 20;

struct Line {
    std::string text;  // without comment; continued lines joined
    int number = 0;    // of its first line in the file
};

std::string_view trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t\r\v\f");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\v\f") - first + 1);
}

std::vector<Line> logical_lines(std::string_view text)
{
    std::vector<Line> lines;
    bool continued = false;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!continued) lines.push_back({{}, number});
        continued = !line.empty() && line.back() == '\\';
        if (continued) line.remove_suffix(1);
        lines.back().text.append(line).append(continued ? " " : "");
    }
    return lines;
}

std::vector<std::string_view> words(std::string_view line)
{
    std::vector<std::string_view> found;
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
        const std::size_t end = std::min(line.find_first_of(" \t\r\v\f"), line.size());
        found.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
    return found;
}

/// The whole word as a number, or false. Independent of the locale; a leading plus is allowed.
template <class Number>
bool parse(std::string_view word, Number& value)
{
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
}

std::string unique_name(const std::string& wanted, std::set<std::string>& taken)
{
    std::string name = wanted;
    for (int copy = 2; !taken.insert(name).second; ++copy) name = wanted + " (" + std::to_string(copy) + ")";
    return name;
}

/// Reads line by line; one member function per kind of line.
class ObjScanner
{
 public:
    ObjScanner(std::string place, std::string default_name, bool by_group)
        : place_(std::move(place)), by_group_(by_group)
    {
        result_.stone_names.push_back(std::move(default_name));  // for faces before the first object
        start_segment(0);
    }

    void read(const Line& line)
    {
        const std::vector<std::string_view> word = words(line.text);
        if (word.empty()) return;
        if (word[0] == "v") read_vertex(word, line.number);
        if (word[0] == "f") read_face(word, line.number);
        if (word[0] == (by_group_ ? "g" : "o"))
            begin_segment(std::string(trimmed(std::string_view(line.text).substr(1))));
    }

    bool too_many_faults() const { return faults_.size() >= most_faults; }

    ObjText finish()
    {
        for (const auto& [index, line] : ahead_)
            if (index > static_cast<long long>(result_.vertices.size()))
                fault(line, "a face names vertex " + std::to_string(index),
                      "the file has " + std::to_string(result_.vertices.size()) + " vertices");
        if (!faults_.empty()) throw InputError(faults_);
        drop_empty_stones();
        if (result_.segments.empty())
            throw InputError(place_, "the file holds no faces", "a mesh file has `v` and `f` lines");
        return std::move(result_);
    }

 private:
    void fault(int line, std::string found, std::string expected)
    {
        if (!too_many_faults())
            faults_.push_back({place_ + ":" + std::to_string(line), std::move(found), std::move(expected)});
    }

    void read_vertex(const std::vector<std::string_view>& word, int line)
    {
        Eigen::Vector3d x = Eigen::Vector3d::Zero();
        bool good = word.size() >= 4;
        for (std::size_t i = 0; good && i < 3; ++i)
            good = parse(word[i + 1], x[static_cast<int>(i)]) && std::isfinite(x[static_cast<int>(i)]);
        if (!good) fault(line, "this vertex is not three finite numbers", "write `v x y z`");
        const std::size_t number = result_.vertices.size();
        result_.structure += "v " + std::to_string(number % numbers_per_row) + " " +
                             std::to_string(number / numbers_per_row) + " 0\n";
        result_.vertices.push_back(x);
    }

    /// Only the vertex numbers are handed on: "7/1/3" becomes "7".
    void read_face(const std::vector<std::string_view>& word, int line)
    {
        if (word.size() < 4) return fault(line, "a face of fewer than three corners", "write `f a b c ...`");
        result_.structure += "f";
        for (std::size_t i = 1; i < word.size(); ++i) {
            const std::string_view number = word[i].substr(0, word[i].find('/'));
            const auto count = static_cast<long long>(result_.vertices.size());
            long long index = 0;
            if (!parse(number, index) || index == 0 || index < -count)
                return fault(line, "a face names vertex \"" + std::string(number) + "\"",
                             "vertices are counted from 1, or backwards from -1");
            if (index > count) ahead_.emplace_back(index, line);
            result_.structure += " " + std::to_string(index);
        }
        result_.structure += "\n";
        result_.segments.back().faces += 1;
        result_.segments.back().corners += word.size() - 1;
    }

    /// An equal group name goes on with the same stone, as the format has it; an equal object name is another
    /// stone.
    void begin_segment(std::string wanted)
    {
        if (wanted.empty()) wanted = by_group_ ? "group" : "object";
        const auto known = stone_of_name_.find(wanted);
        if (by_group_ && known != stone_of_name_.end()) return start_segment(known->second);
        const std::string name = unique_name(wanted, taken_);
        if (name != wanted)
            result_.repairs.push_back("a second object called \"" + wanted + "\" was renamed \"" + name + "\"");
        stone_of_name_.emplace(wanted, static_cast<int>(result_.stone_names.size()));
        result_.stone_names.push_back(name);
        start_segment(static_cast<int>(result_.stone_names.size()) - 1);
    }

    void start_segment(int stone)
    {
        result_.structure += "o " + std::to_string(result_.segments.size()) + "\n";
        result_.segments.push_back({stone, 0, 0});
    }

    void drop_empty_stones()
    {
        std::vector<std::size_t> faces(result_.stone_names.size(), 0);
        std::size_t all = 0;
        for (const ObjSegment& segment : result_.segments) {
            faces[segment.stone] += segment.faces;
            all += segment.faces;
        }
        for (std::size_t stone = 1; stone < faces.size(); ++stone)  // stone 0 is ours: faces before any object
            if (faces[stone] == 0)
                result_.repairs.push_back("\"" + result_.stone_names[stone] + "\" has no faces and was left out");
        if (faces[0] > 0) result_.stone_names[0] = unique_name(result_.stone_names[0], taken_);
        if (all == 0) result_.segments.clear();
    }

    std::string place_;
    bool by_group_;
    ObjText result_;
    std::vector<Fault> faults_;
    std::vector<std::pair<long long, int>> ahead_;  // vertex numbers beyond those read so far, with their lines
    std::map<std::string, int> stone_of_name_;
    std::set<std::string> taken_;
};

ObjText scan(const std::vector<Line>& lines, const std::string& place, const std::string& default_name,
             bool by_group)
{
    ObjScanner scanner(place, default_name, by_group);
    for (const Line& line : lines) {
        scanner.read(line);
        if (scanner.too_many_faults()) break;
    }
    return scanner.finish();
}

std::size_t stones_with_faces(const ObjText& text)
{
    std::set<int> stones;
    for (const ObjSegment& segment : text.segments)
        if (segment.faces > 0) stones.insert(segment.stone);
    return stones.size();
}

}  // namespace

std::size_t vertex_number(double low, double high)
{
    return static_cast<std::size_t>(low) + numbers_per_row * static_cast<std::size_t>(high);
}

ObjText read_obj_text(std::string_view text, const std::string& place, const std::string& default_name)
{
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    if (text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE"))
        throw InputError(place, "the text is UTF-16", "save it as UTF-8 or plain ASCII");
    const std::vector<Line> lines = logical_lines(text);
    ObjText by_object = scan(lines, place, default_name, false);
    const bool has_groups =
        std::any_of(lines.begin(), lines.end(), [](const Line& line) { return line.text.starts_with("g "); });
    return has_groups && stones_with_faces(by_object) < 2 ? scan(lines, place, default_name, true) : by_object;
}

}  // namespace voussoir
