// The helper program and the client that starts it.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>

#include "importers/helper/geometry.h"
#include "importers/helper/import_meshes.h"
#include "importers/mesh/write_obj.h"
#include "importers/patterns/arch_bridge.h"
#include "tests/importers/shapes.h"

namespace voussoir::importers
{
namespace
{

class Helper : public testing::Test
{
 protected:
    void SetUp() override { setenv("VOUSSOIR_BIN_DIR", VOUSSOIR_BINARIES, 1); }
    void TearDown() override { unsetenv("VOUSSOIR_BIN_DIR"); }

    /// Puts a shell script in the helper's place.
    void pretend(const std::string& script)
    {
        const auto file = folder_.write("voussoir-geometry", "#!/bin/sh\n" + script + "\n");
        chmod(file.c_str(), 0755);
        setenv("VOUSSOIR_BIN_DIR", folder_.path().c_str(), 1);
    }
    std::filesystem::path cube_file(const std::string& name = "cube.obj") const
    {
        return folder_.write(name, mesh::to_obj({unit_cube()}, {}));
    }
    std::string refusal(const helper::GeometryLimits& limits = {}) const
    {
        const helper::Geometry geometry = helper::import_geometry({{.file = cube_file()}}, limits);
        EXPECT_EQ(geometry.meshes.size(), 1U);
        EXPECT_FALSE(geometry.meshes[0].accepted);
        return geometry.meshes[0].reason;
    }

    TemporaryFolder folder_;
};

TEST_F(Helper, AnswersWhatTheSameWorkInThisProcessGivesToTheLastBit)
{
    patterns::ArchBridge bridge;
    bridge.rise = 5.123456789;
    const auto file = folder_.write("bridge.obj", mesh::to_obj(patterns::arch_bridge(bridge), {}));
    const std::vector<helper::MeshRequest> requests{{file, 0.3048, 'y'}, {.file = folder_.path() / "none.obj"}};
    const helper::Geometry here = helper::import_meshes(requests), there = helper::import_geometry(requests, {});
    ASSERT_EQ(there.meshes.size(), 2U);
    EXPECT_EQ(there.origin, here.origin);
    EXPECT_TRUE(there.meshes[0].accepted) << there.meshes[0].reason;
    EXPECT_EQ(there.meshes[1].reason, here.meshes[1].reason);
    ASSERT_EQ(there.meshes[0].stones.size(), 95U);
    for (std::size_t i = 0; i < 95; ++i) {
        const helper::Stone &a = here.meshes[0].stones[i], &b = there.meshes[0].stones[i];
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.parts[0].vertices, b.parts[0].vertices);
        EXPECT_EQ(a.parts[0].faces, b.parts[0].faces);
        EXPECT_EQ(a.moments.volume, b.moments.volume);
        EXPECT_EQ(a.moments.second, b.moments.second);
    }
}

TEST_F(Helper, ReportsOverlapsAndRefusedStonesByName)
{
    std::vector<mesh::PolygonSurface> stones{unit_cube(), box({0.5, 0, 0}, {2, 1, 1}), unit_cube()};
    stones[0].name = "left";
    stones[1].name = "right";
    stones[2].name = "open";
    stones[2].faces.pop_back();
    const helper::Geometry geometry =
        helper::import_geometry({{.file = folder_.write("wall.obj", mesh::to_obj(stones, {}))}}, {});
    ASSERT_EQ(geometry.overlaps.size(), 1U);
    EXPECT_EQ(geometry.overlaps[0].stone_a, "left");
    EXPECT_EQ(geometry.overlaps[0].stone_b, "right");
    EXPECT_NEAR(geometry.overlaps[0].volume, 0.5, 1e-15);
    EXPECT_FALSE(geometry.meshes[0].accepted);
    EXPECT_NE(geometry.meshes[0].reason.find("1 of 3 stones refused; open: it is not closed"), std::string::npos)
        << geometry.meshes[0].reason;
}

TEST_F(Helper, ThatCrashesIsARefusalWithTheSignal)
{
    pretend("echo 'free(): invalid pointer' >&2; kill -ABRT $$");
    const std::string reason = refusal();
    EXPECT_NE(reason.find("crashed with signal 6"), std::string::npos) << reason;
    EXPECT_NE(reason.find("free(): invalid pointer"), std::string::npos) << reason;
}

TEST_F(Helper, ThatHangsIsKilledAndIsARefusal)
{
    pretend("exec sleep 60");
    const auto start = std::chrono::steady_clock::now();
    const std::string reason = refusal({.seconds = 0.5});
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    EXPECT_NE(reason.find("did not finish within"), std::string::npos) << reason;
}

TEST_F(Helper, ThatFailsOrTalksNonsenseIsARefusal)
{
    pretend("echo 'no luck' >&2; exit 3");
    EXPECT_NE(refusal().find("exit code 3 (it said: no luck)"), std::string::npos);
    pretend("cat > /dev/null; echo hello");
    EXPECT_NE(refusal().find("its answer is invalid"), std::string::npos);
    pretend(
        "cat > /dev/null; echo '{\"origin\": [0, 0, 0], \"meshes\": [], \"overlaps\": [], \"fit\": "
        "{\"joints\": 0, \"left\": 0, \"misfit_before\": 0, \"misfit_after\": 0}}'");
    EXPECT_NE(refusal().find("another number of files"), std::string::npos);
    setenv("VOUSSOIR_BIN_DIR", "/nowhere", 1);
    EXPECT_NE(refusal().find("cannot be started"), std::string::npos);
}

TEST_F(Helper, ThatOneFileKillsRefusesThatFileOnly)
{
    pretend("input=$(cat); case \"$input\" in *poison*) kill -SEGV $$;; esac; printf '%s' \"$input\" | '" +
            std::string(VOUSSOIR_BINARIES) + "/voussoir-geometry'");
    const helper::Geometry geometry = helper::import_geometry(
        {{.file = cube_file("a.obj")}, {.file = cube_file("poison.obj")}, {.file = cube_file("b.obj")}}, {});
    ASSERT_EQ(geometry.meshes.size(), 3U);
    EXPECT_TRUE(geometry.meshes[0].accepted) << geometry.meshes[0].reason;
    EXPECT_NE(geometry.meshes[1].reason.find("signal 11"), std::string::npos) << geometry.meshes[1].reason;
    EXPECT_TRUE(geometry.meshes[2].accepted);
    EXPECT_EQ(geometry.overlaps.size(), 1U) << "the two cubes that were read lie in each other";
}

// AddressSanitizer reserves terabytes of address space: a limit on it cannot be set, so there is nothing to test.
#if !defined(__SANITIZE_ADDRESS__)
TEST_F(Helper, StaysWithinItsMemory)
{
    std::string text = "o many\n";
    for (int i = 0; i < 2000000; ++i) text += "v 0.123456789 0.123456789 0." + std::to_string(i) + "\n";
    text += "f 1 2 3\n";
    const auto file = folder_.write("many.obj", text);
    const helper::Geometry geometry =
        helper::import_geometry({{.file = file}}, {.seconds = 30, .bytes = std::size_t{100} << 20});
    EXPECT_FALSE(geometry.meshes[0].accepted);
    EXPECT_NE(geometry.meshes[0].reason.find("memory"), std::string::npos) << geometry.meshes[0].reason;
}
#endif

}  // namespace
}  // namespace voussoir::importers
