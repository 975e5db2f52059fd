// What holds for every pattern: it is one sound structure, and it rests. That it is the same when it has been
// written and read back is tested in generate_test.cpp.
#include "tests/app/patterns/every_pattern.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/patterns/pattern_checks.h"

namespace voussoir::app::patterns_test
{
namespace
{

const std::filesystem::path docs = VOUSSOIR_DOCS;

std::string text_of(const std::filesystem::path& file)
{
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Entries of `blocks` that draw stones from a few parameters.
std::set<std::string> kinds_of_patterns()
{
    std::set<std::string> kinds;
    const nlohmann::json schema = nlohmann::json::parse(text_of(docs / "case.schema.json"));
    for (const nlohmann::json& entry : schema.at("properties").at("blocks").at("items").at("oneOf"))
        kinds.insert(entry.at("required").at(0).get<std::string>());
    for (const char* other : {"mesh", "box", "polygon", "polyhedron", "soil"}) kinds.erase(other);
    return kinds;
}

/// The `blocks` of the page's examples, without the lines of other keys.
std::vector<std::string> examples_of(const std::string& page)
{
    std::vector<std::string> examples;
    std::istringstream lines(page);
    std::string own;
    bool is_in = false;
    for (std::string line; std::getline(lines, line);) {
        if (line == "```yaml") {
            own.clear();
        } else if (line == "```" && is_in) {
            examples.push_back(own);
            is_in = false;
        } else if (line == "blocks:") {
            is_in = true;
        } else if (is_in && line.starts_with(" ")) {
            own += line + "\n";
        }
    }
    return examples;
}

TEST(EveryPattern, OfTheSchemaHasAnExampleAndLinesInTheDocuments)
{
    const std::string pages = text_of(docs / "gallery.md") + text_of(docs / "walls_and_houses.md");
    const std::set<std::string> kinds = kinds_of_patterns();
    EXPECT_GE(kinds.size(), 17U);
    for (const std::string& kind : kinds) {
        EXPECT_TRUE(std::any_of(every_pattern.begin(), every_pattern.end(), [&](const PatternExample& example) {
            return example.entry.find(kind + ": {") < 2;
        })) << kind;
        const bool is_shown = pages.find("- " + kind + ":") != std::string::npos ||
                              pages.find("- {" + kind + ":") != std::string::npos;
        EXPECT_TRUE(is_shown) << kind;
    }
}

TEST(EveryPattern, IsOneSoundStructure)
{
    for (const auto& [name, entry] : every_pattern) {
        SCOPED_TRACE(name);
        const Model model = read_pattern(entry).model;
        EXPECT_FALSE(model.foundations.empty());
        expect_sound(assembly_of(model));
    }
}

TEST(EveryPattern, DriftsLessThanAMicrometreInTenSeconds)
{
    for (const auto& [name, entry] : every_pattern) {
        SCOPED_TRACE(name);
        expect_rest(reader::read(pattern_case(entry, 40, 10, 0.05), {"kinematics=spatial_rigid"}));
    }
}

/// Ten lines or fewer, and what they make can be computed.
TEST(GalleryPage, ShowsTenLinesThatAreOneSoundStructure)
{
    const std::vector<std::string> examples = examples_of(text_of(docs / "gallery.md"));
    EXPECT_GE(examples.size(), 12U);
    for (const std::string& example : examples) {
        if (example.find("polyhedron") != std::string::npos) continue;  // the form of a listed block
        SCOPED_TRACE(example);
        EXPECT_LE(std::count(example.begin(), example.end(), '\n'), 10);
        const std::string lines = with(pattern_case("{}"), "\n  - {}\n", "\n" + example);
        const std::string materials =
            "{limestone: {density: 2400 kg/m3, young: 5 GPa, poisson: 0.2}, rubble: "
            "{density: 1800 kg/m3, young: 1 GPa, poisson: 0.2}}";
        const bool has_leaves = example.find("limestone") != std::string::npos;
        const Model model =
            reader::read(lines, has_leaves ? std::vector{"materials=" + materials} : std::vector<std::string>{})
                .model;
        const auto assembly = assembly_of(model);
        EXPECT_TRUE(assembly.overlaps.empty());
        EXPECT_TRUE(assembly.unsupported.empty());
    }
}

}  // namespace
}  // namespace voussoir::app::patterns_test
