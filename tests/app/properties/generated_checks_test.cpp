// Generated cases are accepted, and damaged ones refused in sentences, without being run.
#include <gtest/gtest.h>

#include "libdda/errors.h"
#include "tests/app/properties/generated_reading.h"

namespace voussoir::app::properties
{

TEST(GeneratedChecks, WholeOnesAreAccepted)
{
    const auto [first, end] = seeds();
    std::map<std::string, int> ends;
    for (std::uint64_t seed = first; seed < end; ++seed) {
        try {
            const Case the_case = read(generated(seed), {});
            EXPECT_GE(the_case.model.blocks.size(), 2) << "seed " << seed;
            ++ends["accepted"];
        } catch (const InputError& error) {
            ADD_FAILURE() << "seed " << seed << ": " << error.what();
        }
    }
    count(ends);
}

TEST(GeneratedChecks, DamagedOnesAreRefusedWithAPlaceAndARemedyOrAccepted)
{
    const auto [first, end] = seeds();
    std::map<std::string, int> ends;
    for (std::uint64_t seed = first; seed < end; ++seed) ++ends[read_damaged(seed) ? "accepted" : "refused"];
    count(ends);
    EXPECT_GT(ends["accepted"], 0);
    EXPECT_GT(ends["refused"], 0);
}

// What the tests above are about is in them.
TEST(GeneratedChecks, ScenesAreOfEveryKind)
{
    int walls = 0, doors = 0, meshes = 0, planar = 0, stages = 0;
    std::map<Shaking, int> kinds;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        const GeneratedScene scene = generated(seed);
        walls += scene.wall.has_value();
        doors += scene.wall && scene.wall->door;
        meshes += scene.mesh.has_value();
        planar += scene.flat && (scene.wall || scene.mesh);
        stages += scene.settles && scene.goes_on;
        ++kinds[scene.kind];
    }
    for (const int scenes : {walls, doors, meshes, planar, stages}) EXPECT_GT(scenes, 10);
    EXPECT_EQ(kinds.size(), 4);
}

}  // namespace voussoir::app::properties
