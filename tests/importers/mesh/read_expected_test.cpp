// Every file of the collection of meshes against what is known about it (VOUSSOIR_DATA).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "importers/mesh/read_mesh.h"
#include "libdda/errors.h"

namespace voussoir::importers
{
namespace
{

using Json = nlohmann::json;

/// Files that are refused: a part of the sentence that must be said.
const std::map<std::string, std::string> refusals{
    {"empty.stl", "holds no faces"},
    {"empty.obj", "holds no faces"},
    {"index0.obj", "a face names vertex \"0\""},
    {"index901.obj", "a face names vertex 9"},
    {"malformed.obj", "a face names vertex"},
    {"notenoughindices.obj", "a face of fewer than three corners"},
    {"number_formats.obj", "not three finite numbers"},
    {"issue623.ply", "no element \"face\""},
    {"invalid.off", "does not have the three or more corners it counts"},
    {"BoxWithInfinites.glb", "is not finite"},
    {"IndexOutOfRange.gltf", "a face names vertex"},
    {"sphere.dxf", "1 3DSOLID"},
};

/// Files that are read otherwise than expected.json has them, and why.
struct Difference {
    std::string why;
    int surfaces = 0;
};
const std::map<std::string, Difference> differences{
    {"triangle_with_empty_solid.stl", {"a solid without facets is left out, and this is reported", 1}},
    {"wall-with-opening-and-window.ifc",
     {"expected.json evaluates no solids: a wall, from which the opening is taken, and a window", 2}},
};

std::map<std::string, Json> known_files(std::filesystem::path& folder)
{
    const char* variable = std::getenv("VOUSSOIR_DATA");
    folder = variable != nullptr ? variable : VOUSSOIR_DEFAULT_DATA;
    std::ifstream stream(folder / "expected.json");
    if (!stream) return {};
    return Json::parse(stream).at("meshes").get<std::map<std::string, Json>>();
}

/// The vertices of a surface with those made one that are equal in every bit (0 and -0 are not told apart).
std::vector<int> welded(const mesh::PolygonSurface& surface)
{
    std::map<std::array<double, 3>, int> seen;
    std::vector<int> to;
    for (const Eigen::Vector3d& x : surface.vertices)
        to.push_back(
            seen.emplace(std::array<double, 3>{x.x() + 0.0, x.y() + 0.0, x.z() + 0.0}, seen.size()).first->second);
    return to;
}

/// Whether every edge of the polygons is used exactly twice.
bool closed(const mesh::PolygonSurface& surface)
{
    const std::vector<int> to = welded(surface);
    std::map<std::pair<int, int>, int> uses;
    for (const std::vector<int>& face : surface.faces)
        for (std::size_t i = 0; i < face.size(); ++i) {
            const int a = to[face[i]], b = to[face[(i + 1) % face.size()]];
            if (a != b) ++uses[std::minmax(a, b)];
        }
    return std::all_of(uses.begin(), uses.end(), [](const auto& use) { return use.second == 2; });
}

/// By fans from the first corner.
double signed_volume(const mesh::PolygonSurface& surface)
{
    double volume = 0;
    const Eigen::Vector3d& o = surface.vertices[0];
    for (const std::vector<int>& face : surface.faces)
        for (std::size_t i = 1; i + 1 < face.size(); ++i) {
            const Eigen::Vector3d a = surface.vertices[face[0]] - o, b = surface.vertices[face[i]] - o,
                                  c = surface.vertices[face[i + 1]] - o;
            volume += a.dot(b.cross(c)) / 6;
        }
    return volume;
}

/// Turns faces until neighbours run along their common edge in opposite directions, as the first face has it.
mesh::PolygonSurface oriented(mesh::PolygonSurface surface)
{
    const std::vector<int> to = welded(surface);
    const auto edge = [&](const std::vector<int>& face, std::size_t i) {
        return std::pair(to[face[i]], to[face[(i + 1) % face.size()]]);
    };
    std::multimap<std::pair<int, int>, std::size_t> faces_of;
    for (std::size_t f = 0; f < surface.faces.size(); ++f)
        for (std::size_t i = 0; i < surface.faces[f].size(); ++i)
            faces_of.emplace(std::minmax({edge(surface.faces[f], i).first, edge(surface.faces[f], i).second}), f);
    std::vector<bool> seen(surface.faces.size(), false);
    std::vector<std::size_t> open{0};
    seen[0] = true;
    while (!open.empty()) {
        const std::vector<int> face = surface.faces[open.back()];
        open.pop_back();
        for (std::size_t i = 0; i < face.size(); ++i) {
            const auto [a, b] = edge(face, i);
            for (auto [at, end] = faces_of.equal_range(std::minmax({a, b})); at != end; ++at) {
                if (seen[at->second]) continue;
                std::vector<int>& other = surface.faces[at->second];
                for (std::size_t k = 0; k < other.size(); ++k)
                    if (edge(other, k) == std::pair(a, b)) {
                        std::reverse(other.begin(), other.end());
                        break;
                    }
                seen[at->second] = true;
                open.push_back(at->second);
            }
        }
    }
    return surface;
}

void expect_object(const mesh::PolygonSurface& surface, const Json& object, const std::string& file)
{
    const std::string where = file + ": " + surface.name;
    EXPECT_EQ(surface.faces.size(), object.at("n_faces").get<std::size_t>()) << where;
    EXPECT_EQ(closed(surface), object.at("closed").get<bool>()) << where;
    if (!object.at("closed").get<bool>()) return;
    // The known volumes have nine digits. Where the faces disagree about inside and outside, the known volume is
    // that after turning them.
    const double known = object.at("volume").get<double>();
    if (object.at("consistent_orientation").get<bool>())
        EXPECT_NEAR(signed_volume(surface), known, 6e-9 * std::abs(known)) << where;
    else
        EXPECT_NEAR(std::abs(signed_volume(oriented(surface))), std::abs(known), 6e-9 * std::abs(known)) << where;
}

void expect_as_known(const std::filesystem::path& folder, const std::string& path, const Json& known)
{
    const std::string name = std::filesystem::path(path).filename();
    const auto refusal = refusals.find(name);
    const auto difference = differences.find(name);
    mesh::MeshFile mesh;
    try {
        mesh = mesh::read_mesh(folder / path);
    } catch (const InputError& error) {
        if (refusal == refusals.end())
            ADD_FAILURE() << "refused: " << error.what();
        else
            EXPECT_NE(std::string(error.what()).find(refusal->second), std::string::npos) << error.what();
        return;
    }
    ASSERT_EQ(refusal, refusals.end()) << name << " must be refused";
    if (difference != differences.end()) {
        EXPECT_EQ(mesh.surfaces.size(), static_cast<std::size_t>(difference->second.surfaces)) << name;
        return;
    }
    ASSERT_EQ(mesh.surfaces.size(), known.at("n_objects").get<std::size_t>()) << name;
    for (std::size_t i = 0; i < mesh.surfaces.size(); ++i)
        expect_object(mesh.surfaces[i], known.at("objects")[i], name);
}

TEST(ReadExpected, EveryFileIsReadAsKnownOrTheDifferenceIsExplained)
{
    std::filesystem::path folder;
    const std::map<std::string, Json> known = known_files(folder);
    if (known.empty()) GTEST_SKIP() << "no data: set VOUSSOIR_DATA";
    for (const auto& [path, facts] : known) expect_as_known(folder, path, facts);
}

TEST(ReadExpected, FilesThatAreNoMeshesAreRefusedInWords)
{
    std::filesystem::path folder;
    if (known_files(folder).empty()) GTEST_SKIP() << "no data: set VOUSSOIR_DATA";
    EXPECT_THROW(mesh::read_mesh(folder / "meshes/awkward/IndexOutOfRange.bin"), InputError);
    EXPECT_THROW(mesh::read_mesh(folder / "expected.json"), InputError);
}

TEST(ReadExpected, UnitsAndAxesOfTheFilesAreTold)
{
    std::filesystem::path folder;
    if (known_files(folder).empty()) GTEST_SKIP() << "no data: set VOUSSOIR_DATA";
    struct Known {
        const char* file;
        std::optional<double> metres;
        std::optional<char> up;
    };
    for (const Known& known :
         {Known{"awkward/cube_UTF16LE.dae", 0.01, 'y'}, Known{"awkward/blue_cube.dae", 1, 'z'},
          Known{"awkward/box.3mf", 0.001, 'z'}, Known{"awkward/nested.glb", 1, 'y'},
          Known{"awkward/test1.amf", 0.001, {}}, Known{"masonry/wall.obj", {}, {}},
          Known{"awkward/PinkEggFromLW.dxf", {}, 'z'}, Known{"awkward/fels.3ds", {}, 'z'},
          Known{"building/wall-with-opening-and-window.ifc", 0.001, 'z'}}) {
        const mesh::MeshFile mesh = mesh::read_mesh(folder / "meshes" / known.file);
        EXPECT_EQ(mesh.metres_per_unit.has_value(), known.metres.has_value()) << known.file;
        EXPECT_NEAR(mesh.metres_per_unit.value_or(0), known.metres.value_or(0), 1e-9) << known.file;
        EXPECT_EQ(mesh.up, known.up) << known.file;
    }
}

}  // namespace
}  // namespace voussoir::importers
