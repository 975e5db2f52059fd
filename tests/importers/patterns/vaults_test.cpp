// Domes and vaults as drawn: closed forms of their volumes, joints that coincide, nothing that overlaps.
#include "importers/patterns/vaults.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>

#include "importers/exact/certify.h"
#include "importers/exact/overlap.h"
#include "importers/patterns/survey.h"
#include "tests/importers/patterns/masonry_checks.h"

namespace voussoir::importers
{
namespace
{

using Eigen::Vector3d;
using patterns::StoneGrid;

double volume_of(const StoneGrid& grid, const std::string& prefix)
{
    double volume = 0;
    for (const StoneGrid::Stone& stone : grid.stones())
        if (stone.name.starts_with(prefix)) volume += patterns::volume_of(grid.corners(), stone.faces);
    return volume;
}

/// By name, for messages.
std::vector<std::pair<std::string, StoneGrid>> all_grids()
{
    patterns::Dome aligned{.bonded = false};
    patterns::Dome closed{.keystone = true};
    patterns::BarrelVault unbonded{.bonded = false};
    return {{"bonded dome", patterns::dome({})},
            {"aligned dome", patterns::dome(aligned)},
            {"closed dome", patterns::dome(closed)},
            {"bonded barrel vault", patterns::barrel_vault({})},
            {"unbonded barrel vault", patterns::barrel_vault(unbonded)},
            {"cross vault", patterns::cross_vault({})}};
}

TEST(Vaults, StonesOfADomeHaveTheVolumeOfPyramidsFromItsCentre)
{
    const patterns::Dome dome{
        .radius = 4, .thickness = 0.6, .oculus = 0.3, .springing = 1.4, .courses = 7, .stones = 11};
    // Every half stone is the difference of two similar pyramids over a trapezoid inscribed in the sphere.
    const double turn = std::numbers::pi / 11, band = 1.1 / 7;
    double unit = 0;
    for (int i = 0; i < 7; ++i) {
        const double low = 1.4 - band * i, high = low - band;
        const auto at = [](double angle, double azimuth) {
            return Vector3d(std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth),
                            std::cos(angle));
        };
        const Vector3d a = at(low, 0), b = at(low, turn), c = at(high, turn), d = at(high, 0);
        unit += 22 * (a.dot(b.cross(c)) + a.dot(c.cross(d))) / 6;
    }
    const double expected = unit * (std::pow(4.6, 3) - std::pow(4., 3));
    EXPECT_NEAR(volume_of(patterns::dome(dome), "dome_") / expected, 1, 1e-8);
}

TEST(Vaults, VolumesTendToThoseOfTheRoundBodies)
{
    const auto error = [](const StoneGrid& grid, const char* prefix, double round) {
        return std::abs(volume_of(grid, prefix) / round - 1);
    };
    const double shell =
        2 * std::numbers::pi / 3 * (std::pow(5.5, 3) - std::pow(5., 3)) * (std::cos(0.3) - std::cos(1.2));
    const auto dome = [&](int n) {
        return error(patterns::dome({.oculus = 0.3, .springing = 1.2, .courses = 4 * n, .stones = 10 * n}),
                     "dome_", shell);
    };
    // Between the circles of 5 m and 5.4 m: a semicircle.
    const double tunnel = std::numbers::pi / 2 * (5.4 * 5.4 - 25) * 3;
    const auto barrel = [&](int n) {
        return error(patterns::barrel_vault({.span = 10, .rise = 5, .length = 3, .courses = 8 * n, .stones = 2}),
                     "vault_", tunnel);
    };
    // A half web: (side - r sin t) r dr dt over the ring.
    const double inner = 2.5, outer = 2.8, side = outer + 0.2, quarter = std::numbers::pi / 2;
    const double webs =
        8 * (side * (outer * outer - inner * inner) / 2 * quarter - (std::pow(outer, 3) - std::pow(inner, 3)) / 3);
    const auto cross = [&](int n) {
        const patterns::CrossVault vault{.rise = 2.5, .courses = 5 * n};
        const StoneGrid grid = patterns::cross_vault(vault);
        return std::abs((volume_of(grid, "web_") + volume_of(grid, "groin_")) / webs - 1);
    };
    for (const std::function<double(int)>& of :
         {std::function<double(int)>(dome), std::function<double(int)>(barrel),
          std::function<double(int)>(cross)}) {
        EXPECT_LT(of(8), 1e-3);
        EXPECT_NEAR(of(4) / of(8), 4, 0.1) << "second order: chords for arcs";
    }
}

TEST(Vaults, EveryStoneIsClosedWithFlatFacesAndCertifiedWithoutOverlap)
{
    for (const auto& [name, grid] : all_grids()) {
        SCOPED_TRACE(name);
        std::vector<std::vector<ConvexPolyhedron>> stones;
        for (const mesh::PolygonSurface& surface : patterns::surveyed(grid, {})) {
            const exact::Certificate certificate = exact::certify(surface);
            EXPECT_EQ(certificate.reason, "") << surface.name;
            EXPECT_GT(patterns::volume_of(surface.vertices, surface.faces), 0) << surface.name;
            for (const mesh::Repair& repair : certificate.repairs)
                EXPECT_EQ(repair.text.find("orient"), std::string::npos) << surface.name << ": " << repair.text;
            EXPECT_LE(certificate.parts.size(), 2U) << surface.name;
            EXPECT_LT(certificate.volume_error, 1e-8) << surface.name;
            stones.push_back(certificate.parts);
        }
        EXPECT_TRUE(exact::find_overlaps(stones, 1e-7).empty());
    }
}

TEST(Vaults, ConvexPartsFillTheirStones)
{
    for (const auto& [name, grid] : all_grids()) {
        SCOPED_TRACE(name);
        for (const StoneGrid::Stone& stone : grid.stones()) {
            if (stone.name == "keystone") continue;
            const std::vector<ConvexPolyhedron> parts = patterns::parts_of(grid, stone);
            EXPECT_NEAR(moments_of(parts).volume / patterns::volume_of(grid.corners(), stone.faces), 1, 1e-7);
            std::ptrdiff_t glued = 0;
            for (const ConvexPolyhedron& part : parts)
                glued += std::count(part.glued.begin(), part.glued.end(), true);
            EXPECT_EQ(glued, 2 * (static_cast<std::ptrdiff_t>(parts.size()) - 1)) << stone.name;
        }
    }
}

/// Faces of surfaces by their corners, whatever their direction.
std::map<std::set<std::array<double, 3>>, int> faces_by_corners(const std::vector<mesh::PolygonSurface>& surfaces)
{
    std::map<std::set<std::array<double, 3>>, int> count;
    for (const mesh::PolygonSurface& surface : surfaces)
        for (const std::vector<int>& face : surface.faces) {
            std::set<std::array<double, 3>> corners;
            for (const int v : face)
                corners.insert({surface.vertices[v].x(), surface.vertices[v].y(), surface.vertices[v].z()});
            ++count[corners];
        }
    return count;
}

int faces_shared_by_two(const std::vector<mesh::PolygonSurface>& surfaces)
{
    int shared = 0;
    for (const auto& [corners, count] : faces_by_corners(surfaces)) {
        EXPECT_LE(count, 2);
        shared += count == 2 ? 1 : 0;
    }
    return shared;
}

// 15 stones in 6 courses on 15 supports: 7 rings of 15 head joints; 6 beds of 30 half stones each.
TEST(Vaults, NeighboursShareTheQuadrilateralsOfTheirJointsAlsoWhenWarped)
{
    for (const double warp : {0.0, 0.05}) {
        patterns::Survey survey{.warp = warp};
        EXPECT_EQ(faces_shared_by_two(patterns::surveyed(patterns::dome({}), survey)), 7 * 15 + 6 * 30);
        patterns::Dome aligned{.bonded = false};
        EXPECT_EQ(faces_shared_by_two(patterns::surveyed(patterns::dome(aligned), survey)), 7 * 15 + 6 * 15);
        // Two courses of 3 stones between supports of 3: the second one begins with half a stone.
        const patterns::BarrelVault vault{.courses = 2, .stones = 3};
        EXPECT_EQ(faces_shared_by_two(patterns::surveyed(patterns::barrel_vault(vault), survey)),
                  3 * 6 + 2 + 3 + 2 + 3);
        survey.noise = 1e-3;
        EXPECT_EQ(faces_shared_by_two(patterns::surveyed(patterns::dome({}), survey)), 0);
    }
}

TEST(Vaults, EveryJointOfACrossVaultIsSharedButAtTheSidesOfTheBay)
{
    const double radius = 2.5625, centre = 2 - radius, side = (radius + 0.3) * 2.5 / radius + 0.2;
    const std::vector<mesh::PolygonSurface> surfaces = patterns::surveyed(patterns::cross_vault({}), {});
    const auto count = faces_by_corners(surfaces);
    int at_sides = 0;
    for (const mesh::PolygonSurface& surface : surfaces) {
        if (surface.name.starts_with("support")) continue;
        for (const std::vector<int>& face : surface.faces) {
            std::set<std::array<double, 3>> corners;
            int inside = 0, at_side = 0;
            for (const int v : face) {
                const Vector3d x = surface.vertices[v], distance = x.cwiseAbs();
                corners.insert({x.x(), x.y(), x.z()});
                inside += std::hypot(distance.head<2>().minCoeff(), x.z() - centre) < radius + 0.15 ? 1 : 0;
                at_side += std::abs(distance.head<2>().maxCoeff() - side) < 1e-8 ? 1 : 0;
            }
            const int all = static_cast<int>(face.size());
            if (inside == 0 || inside == all) continue;  // of the extrados, of the intrados
            EXPECT_EQ(count.at(corners), at_side == all ? 1 : 2) << surface.name;
            at_sides += at_side == all ? 1 : 0;
        }
    }
    EXPECT_EQ(at_sides, 8 * 8) << "one for each course of each half web";
}

TEST(Survey, MovesCornersWithinItsSharesAndIsTheSameForTheSameSeed)
{
    const StoneGrid grid = patterns::dome({});
    const auto clean = patterns::surveyed(grid, {});
    const auto warped = patterns::surveyed(grid, {.seed = 7, .warp = 0.05});
    const auto noisy = patterns::surveyed(grid, {.seed = 7, .warp = 0.05, .noise = 1e-3});
    const auto again = patterns::surveyed(grid, {.seed = 7, .warp = 0.05, .noise = 1e-3});
    const auto other = patterns::surveyed(grid, {.seed = 8, .warp = 0.05, .noise = 1e-3});
    double largest_warp = 0, largest_noise = 0;
    for (std::size_t s = 0; s < clean.size(); ++s) {
        const double size = std::cbrt(patterns::volume_of(clean[s].vertices, clean[s].faces));
        EXPECT_GT(patterns::volume_of(clean[s].vertices, clean[s].faces), 0) << "outward";
        for (std::size_t v = 0; v < clean[s].vertices.size(); ++v) {
            const double warp = (warped[s].vertices[v] - clean[s].vertices[v]).cwiseAbs().maxCoeff() / size;
            const double noise = (noisy[s].vertices[v] - warped[s].vertices[v]).cwiseAbs().maxCoeff() / size;
            const bool is_foot = clean[s].vertices[v].z() < -0.4;
            EXPECT_TRUE(!is_foot || warp == 0) << "feet stand on flat ground";
            largest_warp = std::max(largest_warp, warp);
            largest_noise = std::max(largest_noise, noise);
            EXPECT_EQ(noisy[s].vertices[v], again[s].vertices[v]);
            EXPECT_NE(noisy[s].vertices[v], other[s].vertices[v]);
        }
    }
    EXPECT_LE(largest_warp, 0.05 + 1e-8);
    EXPECT_GT(largest_warp, 0.04);
    EXPECT_LE(largest_noise, 1e-3 + 1e-8);
    EXPECT_GT(largest_noise, 0.9e-3);
}

/// Share of the triangles in joints that both stones have.
double matching_triangles(patterns::Diagonals diagonals)
{
    const StoneGrid grid = patterns::dome({.bonded = false});
    const auto surfaces = patterns::surveyed(grid, {.warp = 0.05, .diagonals = diagonals});
    for (const mesh::PolygonSurface& surface : surfaces) EXPECT_EQ(surface.faces.size(), 12U);
    return faces_shared_by_two(surfaces) / (2.0 * (7 * 15 + 6 * 15));
}

TEST(Survey, CutsJointsAlongTheSameDiagonalOnBothSidesOrAtRandom)
{
    EXPECT_EQ(matching_triangles(patterns::Diagonals::shared), 1);
    EXPECT_NEAR(matching_triangles(patterns::Diagonals::random), 0.5, 0.1);  // 195 joints: 2.8 standard deviations
}

TEST(Vaults, NameEveryParameterThatMakesNone)
{
    const std::string dome = refusal_of([] {
        patterns::dome({.radius = -1,
                        .thickness = NAN,
                        .oculus = 0,
                        .springing = 2,
                        .courses = 0,
                        .stones = 2,
                        .support = 0});
    });
    for (const char* name : {"radius", "thickness", "oculus", "springing", "courses", "stones", "support"})
        EXPECT_NE(dome.find(std::string(name) + ": "), std::string::npos) << dome;
    const std::string barrel =
        refusal_of([] { patterns::barrel_vault({.span = 2, .rise = 1.1, .length = 0, .courses = 1}); });
    for (const char* name : {"rise", "length", "courses"})
        EXPECT_NE(barrel.find(std::string(name) + ": "), std::string::npos) << barrel;
    const std::string cross =
        refusal_of([] { patterns::cross_vault({.margin = 0, .courses = 9000, .stones = 9000}); });
    EXPECT_NE(cross.find("margin: "), std::string::npos) << cross;
    EXPECT_NE(refusal_of([] { patterns::cross_vault({.courses = 9000, .stones = 9000}); }).find("more than"),
              std::string::npos);
    const std::string survey =
        refusal_of([] { patterns::surveyed(patterns::dome({}), {.warp = 0.5, .noise = -1}); });
    for (const char* name : {"warp", "noise"})
        EXPECT_NE(survey.find(std::string(name) + ": "), std::string::npos) << survey;
}

}  // namespace
}  // namespace voussoir::importers
