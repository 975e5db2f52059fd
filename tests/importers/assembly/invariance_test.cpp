// What must not depend on where a structure stands, how it is turned, and in which order its stones come.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "importers/assembly/assembly.h"
#include "importers/exact/certify.h"
#include "importers/helper/import_meshes.h"
#include "importers/mesh/read_mesh.h"
#include "importers/mesh/write_obj.h"
#include "importers/patterns/arch_bridge.h"
#include "tests/importers/concave_shapes.h"

namespace voussoir::importers
{
namespace
{

using Eigen::Vector3d;
using Volumes = std::map<std::string, double>;
using Graph = std::map<std::pair<std::string, std::string>, double>;  // pair of names -> area

struct Certified {
    Volumes volumes;
    Graph graph;
};

/// An arch, and beside it an L, a U and a ring sector that stand on its abutment.
std::vector<mesh::PolygonSurface> structure()
{
    patterns::ArchBridge bridge;
    bridge.voussoirs = 15;
    std::vector<mesh::PolygonSurface> stones = patterns::arch_bridge(bridge);
    double top = -1e300, back = 1e300;
    for (const Vector3d& x : stones.front().vertices) {
        top = std::max(top, x.z());
        back = std::min(back, x.x());
    }
    double across = -5;
    for (mesh::PolygonSurface stone : {l_shape(), u_shape(), ring_sector_with_hole()}) {
        stone.name = "concave_" + std::to_string(stones.size());
        for (Vector3d& x : stone.vertices) x += Vector3d(back + 1, across, top);
        across += 4;
        stones.push_back(stone);
    }
    return stones;
}

Certified certified(const std::vector<helper::Stone>& stones)
{
    Certified result;
    std::vector<assembly::AssemblyStone> assembly;
    for (const helper::Stone& stone : stones) {
        EXPECT_EQ(stone.reason, "") << stone.name;
        result.volumes[stone.name] = stone.moments.volume;
        assembly.push_back({stone.name, stone.parts, stone.moments.volume, stone.volume_error, false});
    }
    const assembly::Assembly examined = assembly::examine_assembly(assembly, {}, {});
    for (const assembly::StoneContact& contact : examined.contacts) {
        const auto names = std::minmax(stones[contact.a].name, stones[contact.b].name);
        result.graph[{names.first, names.second}] = contact.area;
    }
    return result;
}

/// In memory: about a local origin, as import_meshes does.
Certified certified(std::vector<mesh::PolygonSurface> surfaces)
{
    Vector3d lower = Vector3d::Constant(1e300), upper = -lower;
    for (const mesh::PolygonSurface& surface : surfaces)
        for (const Vector3d& x : surface.vertices) {
            lower = lower.cwiseMin(x);
            upper = upper.cwiseMax(x);
        }
    const Vector3d origin = (0.5 * lower + 0.5 * upper).array().round();
    std::vector<helper::Stone> stones;
    for (mesh::PolygonSurface& surface : surfaces) {
        for (Vector3d& x : surface.vertices) x -= origin;
        const exact::Certificate certificate = exact::certify(surface);
        helper::Stone& stone = stones.emplace_back();
        stone.name = certificate.name;
        stone.reason = certificate.reason;
        stone.parts = certificate.parts;
        stone.moments = certificate.moments;
        stone.volume_error = certificate.volume_error;
    }
    return certified(stones);
}

void expect_same(const Certified& a, const Certified& b, double volume_tolerance, double area_tolerance)
{
    ASSERT_EQ(a.volumes.size(), b.volumes.size());
    for (const auto& [name, volume] : a.volumes)
        EXPECT_NEAR(b.volumes.at(name), volume, volume_tolerance * volume) << name;
    ASSERT_EQ(a.graph.size(), b.graph.size());
    for (const auto& [pair, area] : a.graph) {
        ASSERT_TRUE(b.graph.contains(pair)) << pair.first << " and " << pair.second;
        EXPECT_NEAR(b.graph.at(pair), area, area_tolerance * area) << pair.first << " and " << pair.second;
    }
}

std::vector<mesh::PolygonSurface> moved(std::vector<mesh::PolygonSurface> surfaces, double angle,
                                        const Vector3d& offset)
{
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    for (mesh::PolygonSurface& surface : surfaces)
        for (Vector3d& x : surface.vertices) x = turn * x + offset;
    return surfaces;
}

const Vector3d national_grid(5e5, 4.6e6, 800);

TEST(Invariance, TranslationToANationalGrid)
{
    const Certified here = certified(structure());
    EXPECT_EQ(here.volumes.size(), 20U);
    EXPECT_EQ(here.graph.size(), 19U) << "16 joints of the arch and three stones on the abutment";
    expect_same(here, certified(moved(structure(), 0, national_grid)), 1e-8, 1e-6);
}

TEST(Invariance, RotationWithAndWithoutTranslation)
{
    const Certified here = certified(structure());
    for (const double angle : {0.3, 1.9, 4.0}) {
        SCOPED_TRACE(angle);
        expect_same(here, certified(moved(structure(), angle, Vector3d::Zero())), 1e-10, 1e-6);
        expect_same(here, certified(moved(structure(), angle, national_grid)), 1e-8, 1e-6);
    }
}

TEST(Invariance, OrderOfTheStones)
{
    const Certified here = certified(structure());
    std::vector<mesh::PolygonSurface> shuffled = structure();
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(7));
    expect_same(here, certified(shuffled), 1e-12, 1e-9);
}

TEST(Invariance, WrittenToObjAtTheNationalGridAndReadBack)
{
    const TemporaryFolder folder;
    const std::vector<mesh::PolygonSurface> far = moved(structure(), 0.3, national_grid);
    const auto file = folder.write("far.obj", mesh::to_obj(far, {}));
    const mesh::MeshFile read = mesh::read_mesh(file);
    ASSERT_EQ(read.surfaces.size(), far.size());
    for (std::size_t i = 0; i < far.size(); ++i) {
        ASSERT_EQ(read.surfaces[i].faces.size(), far[i].faces.size());
        for (std::size_t f = 0; f < far[i].faces.size(); ++f)
            for (std::size_t k = 0; k < far[i].faces[f].size(); ++k)
                ASSERT_EQ(read.surfaces[i].vertices[read.surfaces[i].faces[f][k]],
                          far[i].vertices[far[i].faces[f][k]])
                    << far[i].name << ": every bit";
    }
    const helper::Geometry geometry = helper::import_meshes({{.file = file}});
    ASSERT_TRUE(geometry.meshes[0].accepted) << geometry.meshes[0].reason;
    EXPECT_GT(geometry.origin.norm(), 4e6) << "a local origin is chosen and recorded";
    expect_same(certified(structure()), certified(geometry.meshes[0].stones), 1e-8, 1e-6);
}

}  // namespace
}  // namespace voussoir::importers
