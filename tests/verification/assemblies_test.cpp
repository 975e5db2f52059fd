// From mesh to shaking: every assembly of the data (VOUSSOIR_DATA).
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <set>

#include "importers/helper/geometry.h"
#include "tests/verification/assembly_scene.h"
#include "tests/verification/what_bears.h"

namespace voussoir::verification
{
namespace
{

using nlohmann::json;

enum class Verdict {
    stands,     // rests on its lowest stones, and is shaken
    gives_way,  // accepted; a stone topples or slides on to others under its own weight, as statics says
    falls,      // accepted; statics says that it falls
    cured,      // refused as it is; with the cure it rests and is shaken
    no_stone,   // refused; there is no solid in it
};

struct Assembly {
    Verdict verdict;
    std::string cure;   // keys of the mesh entry
    std::string words;  // of the fault; the stone that topples
};

/// What becomes of each file with several stones, below VOUSSOIR_DATA/meshes.
const std::map<std::string, Assembly> assemblies{
    {"masonry/wall.obj", {Verdict::stands, "", ""}},
    {"masonry/crossvault.obj", {Verdict::stands, "", ""}},
    {"masonry/ursula.obj", {Verdict::gives_way, "", "Mesh 1"}},
    {"masonry/bridge.json", {Verdict::stands, "", ""}},
    {"masonry/A.json", {Verdict::falls, "", ""}},
    {"masonry/H.json", {Verdict::falls, "", ""}},
    {"masonry/cubes.json", {Verdict::stands, "", ""}},
    {"masonry/concave-long.json", {Verdict::stands, "", ""}},
    {"masonry/shelf.json", {Verdict::gives_way, "", "10"}},
    {"masonry/shelf-s1.json", {Verdict::gives_way, "", "11"}},
    {"masonry/type-a.json", {Verdict::stands, "", ""}},
    {"masonry/type-b.json", {Verdict::stands, "", ""}},
    {"masonry/stack_assembly.json", {Verdict::falls, "", ""}},
    {"masonry/arch_assembly.json", {Verdict::stands, "", ""}},
    {"masonry/wall_assembly.json", {Verdict::stands, "", ""}},
    {"building/no_indices_3storybuilding.glb", {Verdict::stands, "", ""}},
    {"building/wall-with-opening-and-window.ifc", {Verdict::cured, "skip: \"IfcWall*\"", "not closed"}},
    {"awkward/twocubes.obj", {Verdict::cured, "hull: twocubes, skip: ledoux", "not closed"}},
    {"awkward/two_objects_1.obj", {Verdict::cured, "skip: cube_2", "not closed"}},
    {"awkward/two_objects.obj", {Verdict::cured, "skip: tetra", "overlap"}},
    {"awkward/joined_tetrahedra.obj", {Verdict::stands, "", ""}},
    {"awkward/multibody.stl", {Verdict::falls, "", ""}},
    {"awkward/nested.glb", {Verdict::falls, "", ""}},
    {"awkward/cube_and_sphere_same_name.3mf", {Verdict::stands, "", ""}},
    {"awkward/hourglass_ico.obj", {Verdict::stands, "", ""}},
    {"awkward/triangle_with_two_solids.stl", {Verdict::no_stone, "", "not closed"}},
    {"awkward/triangle_with_empty_solid.stl", {Verdict::no_stone, "", "not closed"}},
};

/// Of these expected.json knows one object, or none: what they hold is two.
const std::set<std::string> two_in_one{"building/wall-with-opening-and-window.ifc", "awkward/hourglass_ico.obj"};

std::filesystem::path data_folder()
{
    const char* variable = std::getenv("VOUSSOIR_DATA");
    return variable != nullptr ? variable : VOUSSOIR_DEFAULT_DATA;
}

/// The certificate of the mesh, as `import --json` gives it.
json certificate_of(const TemporaryFolder& folder, const std::filesystem::path& mesh)
{
    const app::Ended ended = app::voussoir(folder, {"import", mesh, "--json", "-"});
    const json all = json::parse(ended.output, nullptr, false);
    return all.is_array() && !all.empty() ? all[0] : json::object();
}

int repairs_in(const json& certificate)
{
    std::size_t count = certificate.value("repairs", json::array()).size();
    for (const json& stone : certificate.value("stones", json::array()))
        count += stone.value("repairs", json::array()).size();
    return static_cast<int>(count);
}

/// The level of a stone's lowest and highest corner [m].
std::pair<double, double> levels_of(const importers::helper::Stone& stone)
{
    double lowest = INFINITY, highest = -INFINITY;
    for (const ConvexPolyhedron& part : stone.parts)
        for (const Eigen::Vector3d& x : part.vertices) {
            lowest = std::min(lowest, x.z());
            highest = std::max(highest, x.z());
        }
    return {lowest, highest};
}

/// The stones as drawn; those whose foot lies in the lowest 5 % of the height are held.
Model model_of(const std::filesystem::path& mesh)
{
    setenv("VOUSSOIR_BIN_DIR", VOUSSOIR_BINARIES, 1);
    importers::helper::MeshRequest request;
    request.file = mesh;
    const importers::helper::Geometry geometry = importers::helper::import_geometry({request}, {});
    JointMaterial dry;
    dry.name = "dry";
    Model model = make_model(Kinematics::spatial_rigid, {"stone", 2200, 10e9, 0.2}, dry);
    double foot = INFINITY, top = -INFINITY;
    for (const importers::helper::Stone& stone : geometry.meshes.at(0).stones) {
        const auto [lowest, highest] = levels_of(stone);
        foot = std::min(foot, lowest);
        top = std::max(top, highest);
    }
    for (const importers::helper::Stone& stone : geometry.meshes.at(0).stones) {
        model.blocks.push_back(make_block(stone.name, 0, 0, stone.parts, stone.moments));
        if (levels_of(stone).first > foot + 0.05 * (top - foot)) continue;
        Foundation held;
        held.block = static_cast<int>(model.blocks.size()) - 1;
        model.foundations.push_back(held);
    }
    return model;
}

/// Why statics says that a stone falls. @returns its name and the cause
std::string cause_of(const Model& model, const std::string& name, const decltype(why_it_falls)& why)
{
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        if (model.blocks[b].name != name) continue;
        const std::string cause = why(model, static_cast<int>(b));
        EXPECT_NE(cause, "") << "statics does not say why " << name << " falls";
        return name + ": " + cause;
    }
    ADD_FAILURE() << "no stone " << name;
    return "";
}

std::string expect_collapse(const TemporaryFolder& folder, const Scene& scene)
{
    const Outcome resting = started(folder, "run", scene.text(rest));
    EXPECT_EQ(resting.word(), "collapsed") << "it finds no rest";
    EXPECT_EQ(resting.unconverged(), 0);
    // Let go, it falls.
    const Outcome falling = started(folder, "run", scene.text(fall));
    EXPECT_EQ(falling.word(), "collapsed") << falling.said;
    EXPECT_EQ(falling.unconverged(), 0);
    const Model model = model_of(scene.mesh);
    std::string told;
    for (const json& fallen : falling.summary.value("fallen_blocks", json::array())) {
        const std::string name = fallen.at("block"), message = resting.summary.value("message", "");
        EXPECT_NE(message.find("'" + name + "'"), std::string::npos) << message;
        told += (told.empty() ? "" : "; ") + cause_of(model, name, why_it_falls);
    }
    EXPECT_NE(told, "") << "no stone is named";
    return "collapsed: " + told;
}

std::string why_it_gives_way(const Model& model, int stone)
{
    const std::string topples = why_it_topples(model, stone);
    return topples.empty() ? why_it_slides(model, stone, 37 * std::numbers::pi / 180) : topples;
}

std::string expect_giving_way(const TemporaryFolder& folder, const Scene& scene, const std::string& stone)
{
    const Outcome resting = started(folder, "run", scene.text(rest));
    EXPECT_EQ(resting.word(), "collapsed") << resting.said;
    EXPECT_EQ(resting.unconverged(), 0);
    const std::string message = resting.summary.value("message", "");
    EXPECT_NE(message.find("'" + stone + "'"), std::string::npos) << message;
    return "collapsed: " + cause_of(model_of(scene.mesh), stone, why_it_gives_way);
}

std::string expect_refusal(const TemporaryFolder& folder, const Scene& scene, const std::string& words)
{
    const Outcome checked = started(folder, "check", scene.text(std::string(rest) + shaking));
    EXPECT_EQ(checked.exit_code, 2);
    EXPECT_NE(checked.said.find(words), std::string::npos) << checked.said;
    return "refused";
}

TEST(Assemblies, EveryFileWithSeveralStonesIsInTheTable)
{
    const std::filesystem::path file = data_folder() / "expected.json";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no data: set VOUSSOIR_DATA";
    std::set<std::string> several = two_in_one, listed;
    const json expected = json::parse(app::contents(file));
    for (const auto& [name, known] : expected.at("meshes").items())
        if (known.value("n_objects", 0) >= 2) several.insert(name.substr(std::string("meshes/").size()));
    for (const auto& [name, assembly] : assemblies) listed.insert(name);
    EXPECT_EQ(listed, several);
}

TEST(Assemblies, OfTheDataRunFromMeshToShakingOrFallAsStaticsSays)
{
    if (!std::filesystem::exists(data_folder() / "expected.json")) GTEST_SKIP() << "no data: set VOUSSOIR_DATA";
    std::printf("%-42s %6s %8s  %-30s %s\n", "file", "stones", "repairs", "cure", "what becomes of it");
    for (const auto& [name, assembly] : assemblies) {
        SCOPED_TRACE(name);
        const TemporaryFolder folder;
        Scene scene{data_folder() / "meshes" / name, "", "{lowest: 5 %}", ""};
        const json certificate = certificate_of(folder, scene.mesh);
        std::string told;
        if (assembly.verdict == Verdict::cured || assembly.verdict == Verdict::no_stone)
            told = expect_refusal(folder, scene, assembly.words);
        if (assembly.verdict == Verdict::cured) {
            scene.keys = assembly.cure;
            told += ", then " + expect_rest_and_shaking(folder, scene);
        }
        if (assembly.verdict == Verdict::stands) told = expect_rest_and_shaking(folder, scene);
        if (assembly.verdict == Verdict::gives_way) told = expect_giving_way(folder, scene, assembly.words);
        if (assembly.verdict == Verdict::falls) told = expect_collapse(folder, scene);
        std::printf("%-42s %6zu %8d  %-30s %s\n", name.c_str(), certificate.value("stones", json::array()).size(),
                    repairs_in(certificate), assembly.cure.c_str(), told.c_str());
    }
}

}  // namespace
}  // namespace voussoir::verification
