#include "app/reader/yaml_tree.h"

#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <fmt/core.h>

#include <sstream>
#include <utility>

#include "app/words/lines.h"
#include "libdda/errors.h"

namespace voussoir::app::reader
{
namespace
{

constexpr std::size_t max_nodes = 1'000'000;

/// Where a line is, for faults.
struct Placer {
    const std::string& name;
    bool with_lines;
    std::string at(int line) const { return with_lines ? name + ":" + std::to_string(line) : name; }
};

/// Bytes that no text has, and bytes that are not UTF-8. @returns the offset of the first one, or npos
std::size_t find_noise(const std::string& text)
{
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const bool control = (byte < 0x20 && byte != '\n' && byte != '\r' && byte != '\t') || byte == 0x7f;
        std::size_t length = 1;
        if (byte >= 0xc2 && byte <= 0xdf) length = 2;
        if (byte >= 0xe0 && byte <= 0xef) length = 3;
        if (byte >= 0xf0 && byte <= 0xf4) length = 4;
        if (control || (byte >= 0x80 && length == 1) || i + length > text.size()) return i;
        for (std::size_t k = 1; k < length; ++k)
            if ((static_cast<unsigned char>(text[i + k]) & 0xc0) != 0x80) return i;
        i += length;
    }
    return std::string::npos;
}

int line_of(const std::string& text, std::size_t offset)
{
    int line = 1;
    for (std::size_t i = 0; i < offset; ++i) line += text[i] == '\n' ? 1 : 0;
    return line;
}

/// A tab in the indentation is the most frequent mistake, and yaml-cpp's words for it help nobody.
void refuse_tabs(const std::string& text, const Placer& placer)
{
    int number = 0;
    for (const std::string& line : words::lines_of(text)) {
        ++number;
        const std::size_t start = line.find_first_not_of(" \t\r");
        if (start == std::string::npos || line[start] == '#') continue;
        if (line.find('\t') < start)
            throw InputError(placer.at(number), "a tab in the indentation", "indent with spaces");
    }
}

/// yaml-cpp takes a second for each megabyte of open brackets before it gives up.
void refuse_open_brackets(const std::string& text, const Placer& placer)
{
    constexpr int deepest = 1000;  // brackets in quotes and comments count too, so this is generous
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '[' || text[i] == '{') ++depth;
        if (text[i] == ']' || text[i] == '}') --depth;
        if (depth > deepest)
            throw InputError(placer.at(line_of(text, i)), "more than 1000 brackets that are not closed",
                             "a case has only a few levels of nesting");
    }
}

void refuse_noise(const std::string& text, const Placer& placer)
{
    if (text.size() > largest_case_file)
        throw InputError(placer.name, fmt::format("{} bytes", text.size()), "a case file has at most 16 MiB");
    const std::size_t noise = find_noise(text);
    if (noise != std::string::npos)
        throw InputError(placer.at(line_of(text, noise)),
                         fmt::format("byte 0x{:02x} is not text", static_cast<unsigned char>(text[noise])),
                         "a case file is YAML in UTF-8");
}

/// Builds the tree from yaml-cpp's events.
class TreeBuilder : public YAML::EventHandler
{
 public:
    explicit TreeBuilder(const Placer& placer) : placer_(placer) {}

    void OnDocumentStart(const YAML::Mark&) override {}
    void OnDocumentEnd() override {}
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override
    {
        refuse(mark, "an alias (*)", "write the value itself; anchors and aliases are not supported");
    }
    void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { add(node(YamlNode::Kind::null, mark, "")); }
    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t, const std::string& text) override
    {
        YamlNode scalar = node(YamlNode::Kind::scalar, mark, tag);
        scalar.text = text;
        add(std::move(scalar));
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                         YAML::EmitterStyle::value) override
    {
        open_.push_back(node(YamlNode::Kind::list, mark, tag));
    }
    void OnSequenceEnd() override { close(); }
    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                    YAML::EmitterStyle::value) override
    {
        open_.push_back(node(YamlNode::Kind::map, mark, tag));
    }
    void OnMapEnd() override { close(); }

    YamlNode root;

 private:
    [[noreturn]] void refuse(const YAML::Mark& mark, const std::string& found, const std::string& expected) const
    {
        throw InputError(placer_.at(mark.line + 1), found, expected);
    }
    YamlNode node(YamlNode::Kind kind, const YAML::Mark& mark, const std::string& tag)
    {
        // yaml-cpp gives "?" to what is plain and "!" to what is quoted.
        if (!tag.empty() && tag != "?" && tag != "!") refuse(mark, "the tag " + tag, "tags are not supported");
        if (++nodes_ > max_nodes) refuse(mark, "more than a million values", "split or shorten the case");
        YamlNode made;
        made.kind = kind;
        made.line = mark.line + 1;
        return made;
    }
    void close()
    {
        YamlNode done = std::move(open_.back());
        open_.pop_back();
        add(std::move(done));
    }
    void add(YamlNode done)
    {
        if (open_.empty()) {
            root = std::move(done);
            return;
        }
        YamlNode& parent = open_.back();
        const bool is_key = parent.kind == YamlNode::Kind::map && parent.keys.size() == parent.items.size();
        if (!is_key) {
            parent.items.push_back(std::move(done));
        } else if (done.kind == YamlNode::Kind::scalar) {
            parent.keys.push_back(std::move(done.text));
        } else {
            throw InputError(placer_.at(done.line), describe(done) + " where a key should be", "a key is a word");
        }
    }

    const Placer& placer_;
    std::vector<YamlNode> open_;  // lists and maps under way, outermost first
    std::size_t nodes_ = 0;
};

}  // namespace

std::string describe(const YamlNode& node)
{
    if (node.kind == YamlNode::Kind::null) return "nothing";
    if (node.kind == YamlNode::Kind::list) return "a list";
    if (node.kind == YamlNode::Kind::map) return "a map of keys";
    constexpr std::size_t longest = 60;
    std::string text = node.text.substr(0, longest);
    for (char& letter : text)
        if (letter == '\n' || letter == '\r') letter = ' ';
    return "\"" + text + (node.text.size() > longest ? "...\"" : "\"");
}

YamlNode parse_yaml(const std::string& text, const std::string& name, bool with_lines)
{
    const Placer placer{name, with_lines};
    refuse_noise(text, placer);
    refuse_open_brackets(text, placer);
    refuse_tabs(text, placer);
    TreeBuilder builder(placer);
    try {
        std::istringstream stream(text);
        YAML::Parser parser(stream);
        parser.HandleNextDocument(builder);
        TreeBuilder rest(placer);
        if (parser.HandleNextDocument(rest) && rest.root.kind != YamlNode::Kind::null)
            throw InputError(placer.at(rest.root.line), "a second YAML document", "one case per file");
    } catch (const YAML::DeepRecursion& error) {
        throw InputError(placer.at(error.mark.line + 1), "lists or maps nested too deep",
                         "a case has only a few levels of nesting");
    } catch (const YAML::Exception& error) {
        throw InputError(placer.at(error.mark.is_null() ? 1 : error.mark.line + 1), "not valid YAML: " + error.msg,
                         "check the indentation, brackets and quotes here and on the line before");
    }
    return std::move(builder.root);
}

}  // namespace voussoir::app::reader
