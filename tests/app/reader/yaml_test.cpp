// The tree, the cursor and the overrides: places, duplicates, unknown keys, hostile text.
#include <gtest/gtest.h>

#include "app/reader/overrides.h"
#include "app/reader/yaml_cursor.h"
#include "app/words/nearest_word.h"

namespace voussoir::app::reader
{
namespace
{

std::string refusal_of(const std::string& text)
{
    try {
        parse_yaml(text, "case.yaml");
    } catch (const InputError& error) {
        EXPECT_EQ(error.faults.size(), 1);
        return error.what();
    }
    return "accepted";
}

void expect_start(const std::string& sentence, const std::string& start)
{
    EXPECT_TRUE(sentence.starts_with(start)) << sentence;
}

TEST(YamlTree, RemembersLinesAndDuplicates)
{
    const YamlNode root = parse_yaml("a: 1\nb:\n  - x\n  - {c: 2, c: 3}\n", "case.yaml");
    ASSERT_EQ(root.keys, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(root.items[1].items[0].line, 3);
    EXPECT_EQ(root.items[1].items[1].keys, (std::vector<std::string>{"c", "c"}));
}

TEST(YamlTree, RefusesWhatIsNoCaseWithOneSentenceAndALine)
{
    expect_start(refusal_of("a:\n\tb: 1\n"), "case.yaml:2: a tab in the indentation; indent with spaces");
    expect_start(refusal_of("a: &x 1\nb: *x\n"), "case.yaml:2: an alias (*); ");
    expect_start(refusal_of("a: 1\n---\nb: 2\n"), "case.yaml:3: a second YAML docume");
    expect_start(refusal_of("a: !!int 1\n"), "case.yaml:1: the tag");
    expect_start(refusal_of("a: 1\n[b]: 2\n"), "case.yaml:2: a list");
    expect_start(refusal_of("a: 1\nb: [1, 2\nc: 3\n"), "case.yaml:3: not valid YAML: ");
    expect_start(refusal_of(std::string("a: 1\nb: \0\n", 10)), "case.yaml:2: byte 0x00 is ");
    expect_start(refusal_of("a: 1\nb: \xff\xfe\n"), "case.yaml:2: byte 0xff is ");
}

TEST(YamlTree, BoundsWhatHostileTextCanCost)
{
    EXPECT_NE(refusal_of(std::string(100'000, '[')), "accepted");
    EXPECT_NE(refusal_of(std::string(100'000, '{')), "accepted");
    std::string dashes;
    for (int i = 0; i < 2000; ++i) dashes += "- ";
    EXPECT_NE(refusal_of(dashes), "accepted");
    std::string wide = "a: [";
    for (int i = 0; i < 1'100'000; ++i) wide += "1,";
    EXPECT_NE(refusal_of(wide + "]").find("more than a million values"), std::string::npos);
    EXPECT_NE(refusal_of(std::string(largest_case_file + 1, 'a')).find("at most 16 MiB"), std::string::npos);
}

TEST(YamlCursor, ReportsEverythingAtOnceWithPlaces)
{
    const YamlNode root = parse_yaml("stone:\n  yuong: 4.5 GPa\n  density: 3 Pa\n  density: 4\n", "case.yaml");
    Findings findings;
    findings.file = "case.yaml";
    YamlCursor top(root, "", findings);
    YamlCursor stone = *top.find("stone");
    stone.quantity("young", words::dimension::pressure, words::Range::positive());
    stone.quantity("density", words::dimension::density, words::Range::positive());
    stone.reject_unknown_keys();
    top.reject_unknown_keys();
    std::vector<std::string> sentences;
    for (const Fault& fault : findings.faults) sentences.push_back(to_sentence(fault));
    EXPECT_EQ(sentences,
              (std::vector<std::string>{
                  "case.yaml:2: stone.young: missing; give a pressure such as 4.5 GPa",
                  "case.yaml:3: stone.density: \"3 Pa\" has the wrong dimension; expected a density such as "
                  "2400 kg/m3",
                  "case.yaml:2: stone.yuong: unknown key; did you mean young?",
                  "case.yaml:4: stone.density: given twice (first in line 3); keep one of them"}));
}

TEST(YamlCursor, TakesDefaultsAloud)
{
    const YamlNode root = parse_yaml("a: 1", "case.yaml");
    Findings findings;
    YamlCursor top(root, "", findings);
    EXPECT_DOUBLE_EQ(top.quantity_or("step", words::dimension::time, words::Range::positive(), 2e-3), 2e-3);
    EXPECT_EQ(top.integer_or("count", 1, 9, 4), 4);
    EXPECT_EQ(in_words(findings.defaults), std::vector<std::string>{"step = 0.002 s, count = 4"});
}

/// The faults of one override applied to a small case.
std::string override_faults(const std::string& setting, YamlNode& root)
{
    Findings findings;
    apply_override(setting, root, findings);
    return findings.faults.empty() ? "" : to_sentence(findings.faults.front());
}

TEST(Overrides, SetCreateAppendAndTakeAway)
{
    YamlNode root = parse_yaml("stages:\n  - {type: static}\n  - {type: dynamic, time_step: 2 ms}\n", "case.yaml");
    expect_start(override_faults("stages[1].time_step=1 ms", root), "");
    EXPECT_EQ(root.items[0].items[1].items[1].text, "1 ms");
    EXPECT_EQ(root.items[0].items[1].items[1].origin, "--set stages[1].time_step");
    EXPECT_EQ(override_faults("output.histories={top: {block: a}}", root), "");
    EXPECT_EQ(root.keys.back(), "output");
    EXPECT_EQ(override_faults("stages[2]={type: dynamic}", root), "");
    EXPECT_EQ(root.items[0].items.size(), 3);
    EXPECT_EQ(override_faults("stages[1].time_step=null", root), "");
    EXPECT_EQ(root.items[0].items[1].keys, std::vector<std::string>{"type"});
}

TEST(Overrides, SayWhatCannotBeDone)
{
    YamlNode root = parse_yaml("stages: [{type: static}]\ntitle: x\n", "case.yaml");
    EXPECT_EQ(override_faults("stages[5].a=1", root),
              "--set stages[5].a: no position [5]; the list has 1 entries, from [0]");
    expect_start(override_faults("title.a=1", root), "--set title.a: cannot set a in \"x\"; ");
    expect_start(override_faults("stages.type=1", root), "--set stages.type: cannot set type in a list; ");
    for (const char* setting : {"title", "=1", "a..b=1", "a.=1", ".a=1", "a[=1", "a[-1]=1", "a[1]b=1", "[0]=1"})
        EXPECT_NE(override_faults(setting, root).find("not a setting"), std::string::npos) << setting;
    EXPECT_NE(override_faults("a=[1", root).find("--set a: not valid YAML"), std::string::npos);
}

TEST(NearestWord, KnowsWhatWasMeant)
{
    EXPECT_EQ(words::edit_distance("young", "yuong"), 1);
    EXPECT_EQ(words::edit_distance("kitten", "sitting"), 3);
    EXPECT_EQ(words::nearest_word("timestep", {"type", "time_step", "name"}), "time_step");
    EXPECT_EQ(words::nearest_word("wholly_other", {"type", "time_step", "name"}), "");
    EXPECT_EQ(words::nearest_word("q", {"x", "y", "z"}), "");
}

}  // namespace
}  // namespace voussoir::app::reader
