// `voussoir generate`: what it writes is the same model when it is read back.
#include <cstdlib>

#include "importers/helper/import_meshes.h"
#include "tests/app/patterns/every_pattern.h"
#include "tests/app/patterns/pattern_checks.h"

namespace voussoir::app::patterns_test
{
namespace
{

int run_program(const std::string& arguments)
{
    const int status =
        std::system(("'" + std::string(VOUSSOIR_PROGRAM) + "' " + arguments + " > /dev/null 2>&1").c_str());
    return WEXITSTATUS(status);
}

TEST(Generate, WritesCasesThatAreTheSameModel)
{
    for (const auto& [pattern, entry] : every_pattern) {
        SCOPED_TRACE(pattern);
        const TemporaryFolder folder;
        const std::filesystem::path file = folder.write("case.yaml", pattern_case(entry)),
                                    back = folder.path() / "back.yaml";
        ASSERT_EQ(run_program("generate '" + file.string() + "' -o '" + back.string() + "'"), 0);
        const Model drawn = reader::read_case(file, {}).model, read = reader::read_case(back, {}).model;
        ASSERT_EQ(drawn.blocks.size(), read.blocks.size());
        EXPECT_EQ(drawn.foundations.size(), read.foundations.size());
        for (std::size_t b = 0; b < drawn.blocks.size(); ++b) {
            const Block &one = drawn.blocks[b], &other = read.blocks[b];
            EXPECT_EQ(one.name, other.name);
            EXPECT_EQ(drawn.groups[one.group], read.groups[other.group]);
            EXPECT_EQ(one.friction_factor, other.friction_factor);
            EXPECT_EQ(one.attached_mass, other.attached_mass);
            EXPECT_NEAR(one.moments.volume, other.moments.volume, 1e-12);
            EXPECT_NEAR((one.moments.centroid - other.moments.centroid).norm(), 0, 1e-12);
            EXPECT_NEAR((drawn.mass_second(static_cast<int>(b)) - read.mass_second(static_cast<int>(b))).norm(), 0,
                        1e-9 * drawn.mass(static_cast<int>(b)));
            ASSERT_EQ(one.parts.size(), other.parts.size());
            for (std::size_t p = 0; p < one.parts.size(); ++p) {
                EXPECT_EQ(one.parts[p].faces, other.parts[p].faces);
                for (std::size_t f = 0; f < one.parts[p].faces.size(); ++f)
                    EXPECT_EQ(one.parts[p].is_glued(static_cast<int>(f)),
                              other.parts[p].is_glued(static_cast<int>(f)));
            }
        }
    }
}

/// The same certificate as a mesh: no repair, the same stones, volumes and places.
TEST(Generate, WritesMeshesThatAreCertifiedAsTheyAre)
{
    for (const auto& [pattern, entry] : every_pattern) {
        SCOPED_TRACE(pattern);
        const TemporaryFolder folder;
        const std::filesystem::path file = folder.write("case.yaml", pattern_case(entry)),
                                    mesh = folder.path() / "back.obj";
        ASSERT_EQ(run_program("generate '" + file.string() + "' -o '" + mesh.string() + "'"), 0);
        const Model drawn = reader::read_case(file, {}).model;
        const importers::helper::Geometry geometry = importers::helper::import_meshes({{.file = mesh}});
        ASSERT_TRUE(geometry.meshes[0].accepted) << geometry.meshes[0].reason;
        EXPECT_TRUE(geometry.overlaps.empty());
        ASSERT_EQ(geometry.meshes[0].stones.size(), drawn.blocks.size());
        for (std::size_t b = 0; b < drawn.blocks.size(); ++b) {
            const importers::helper::Stone& stone = geometry.meshes[0].stones[b];
            EXPECT_EQ(stone.name, drawn.blocks[b].name);
            EXPECT_NEAR(stone.moments.volume, drawn.blocks[b].moments.volume, 1e-7) << stone.name;
        }
    }
}

TEST(Generate, TakesPatternsByTheirKeys)
{
    const TemporaryFolder folder;
    const std::string mesh = "'" + (folder.path() / "a.obj").string() + "'";
    EXPECT_EQ(run_program("generate arch span='5 m' thickness=0.5 voussoirs=11 -o " + mesh), 0);
    EXPECT_EQ(run_program("generate wall length=3 height=2 thickness=0.4 'block=[0.6, 0.3]' -o " + mesh), 0);
    EXPECT_EQ(run_program("generate arch span='5 m' thickness=0.5 voussoirs=1 -o " + mesh), 2);
    EXPECT_EQ(run_program("generate arc span='5 m' -o " + mesh), 2);
    EXPECT_EQ(run_program("generate arch span='5 m' thickness=0.5 voussoirs=11 -o '" +
                          (folder.path() / "a.stl").string() + "'"),
              2);
    EXPECT_EQ(run_program("generate arch span -o " + mesh), 2);
}

TEST(Generate, KeepsTheRestOfACase)
{
    const TemporaryFolder folder;
    const std::filesystem::path back = folder.path() / "back.yaml";
    ASSERT_EQ(run_program(std::string("generate '") + VOUSSOIR_CASES + "/column.yaml' -o '" + back.string() + "'"),
              0);
    // Its records lie beside the case, not beside the copy.
    const Case read = reader::read_case(back, {"foundation.motion=null"});
    EXPECT_EQ(read.model.blocks.size(), 11U);
    EXPECT_EQ(read.stages.size(), 2U);
    EXPECT_EQ(read.output.histories.size(), 2U);
    EXPECT_EQ(read.title, "A multidrum column");
}

/// Faults of stones that are listed are told where they stand.
TEST(Generate, ListedStonesAreChecked)
{
    const std::string stone =
        "{polyhedron: {name: a, parts: [{vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], "
        "faces: [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]}]}, group: foundation}";
    EXPECT_NEAR(reader::read(pattern_case(stone)).model.blocks[0].moments.volume, 1.0 / 6, 1e-15);
    EXPECT_NE(reader::faults_of(pattern_case(with(stone, "[0, 2, 1]", "[0, 2, 4]"))).find("0 to 3"),
              std::string::npos);
    EXPECT_NE(reader::faults_of(pattern_case(with(stone, "[0, 2, 1], ", ""))).find("parts[0]"), std::string::npos);
}

}  // namespace
}  // namespace voussoir::app::patterns_test
