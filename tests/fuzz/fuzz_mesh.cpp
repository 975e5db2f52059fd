// A libFuzzer target: any bytes, read as a mesh file by our own readers. InputError is what they may answer; all
// else is a finding. assimp is left out: it does not survive damage, which is why reading runs in a limited child;
// what only assimp reads is refused here. Its seeds are in seeds/assimp, for the test of the child.
//
// The first byte of an input chooses the ending of the file's name and what becomes a stone, see below.

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "importers/mesh/read_mesh.h"
#include "libdda/errors.h"
#include "tests/fuzz/accepted_mesh.h"
#include "tests/temporary_folder.h"

namespace
{

using namespace voussoir;
using namespace voussoir::importers::mesh;
namespace fs = std::filesystem;

constexpr std::array<const char*, 16> endings{"obj", "stl", "ply", "off",  "gltf", "glb", "dae", "3mf",
                                              "amf", "3ds", "dxf", "json", "",     "txt", "xml", "obj"};
constexpr std::array<StonesBy, 5> levels{StonesBy::detect, StonesBy::file, StonesBy::object, StonesBy::group,
                                         StonesBy::node};

}  // namespace

/// Bits 0 to 3 of the first byte choose the ending, 4 to 6 the level of the stones; the rest is the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const TemporaryFolder temporary;
    const fs::path& folder = temporary.path();
    if (size == 0) return 0;
    const std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
    const fs::path file = folder / (std::string("mesh.") + endings[data[0] & 15U]);
    std::ofstream(file, std::ios::binary) << bytes;
    try {
        check_accepted(read_mesh(file, {levels[(data[0] >> 4U & 7U) % levels.size()], MeshReader::own}));
    } catch (const InputError&) {
    }
    return 0;
}
