// Vaults with warped joints, as surveys deliver them.
#pragma once

#include "tests/verification/assembly_scene.h"

namespace voussoir::verification
{

/// Joints warped by 5 %, noise of 0.1 % and random diagonals.
inline constexpr const char* as_surveyed = " --warp 5% --noise 0.1% --diagonals random";

/// Makes a mesh by voussoir-generate. @returns its file
inline std::string generated(const TemporaryFolder& folder, const std::string& pattern)
{
    const std::string file = folder / "vault.obj";
    const std::string command =
        std::string("'") + VOUSSOIR_BINARIES + "/voussoir-generate' " + pattern + " -o '" + file + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return file;
}

inline void expect_vault_is_shaken(const std::string& pattern, int seed)
{
    SCOPED_TRACE(pattern + ", seed " + std::to_string(seed));
    const TemporaryFolder folder;
    const std::string mesh = generated(folder, pattern + as_surveyed + " --seed " + std::to_string(seed));
    const Scene scene{mesh, "", "\"support_*\"", "kinematics: spatial_rigid\n"};
    std::printf("%s, seed %d: %s\n", pattern.c_str(), seed, expect_rest_and_shaking(folder, scene).c_str());
}

// Of about 400 stones.
inline constexpr const char* dome = "dome --courses 16 --stones 24 --thickness 0.4 --oculus 12";
inline constexpr const char* barrel = "barrel-vault --courses 20 --stones 19 --length 8";
inline constexpr const char* cross = "cross-vault --courses 13 --stones 9";

}  // namespace voussoir::verification
