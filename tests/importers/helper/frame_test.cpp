// Unit, axis and what becomes a stone: what the user says, else what the file says.
#include <gtest/gtest.h>

#include "importers/helper/import_meshes.h"
#include "importers/mesh/write_obj.h"
#include "tests/importers/shapes.h"

namespace voussoir::importers
{
namespace
{

/// A box of 1 x 2 x 3 file units whose unit and up axis COLLADA states.
std::string collada()
{
    return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g" name="box"><mesh>
<source id="p"><float_array id="a" count="24">0 0 0 1 0 0 1 2 0 0 2 0 0 0 3 1 0 3 1 2 3 0 2 3</float_array>
<technique_common><accessor source="#a" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="6"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4 4 4 4 4 4</vcount>
<p>3 2 1 0 4 5 6 7 0 1 5 4 1 2 6 5 2 3 7 6 3 0 4 7</p></polylist></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

Eigen::Vector3d extent(const helper::Stone& stone)
{
    Eigen::Vector3d lower = stone.parts[0].vertices[0], upper = lower;
    for (const Eigen::Vector3d& x : stone.parts[0].vertices) {
        lower = lower.cwiseMin(x);
        upper = upper.cwiseMax(x);
    }
    return upper - lower;
}

TEST(Frame, UnitAndAxisComeFromTheFileUnlessTheUserSaysOtherwise)
{
    const TemporaryFolder folder;
    const auto file = folder.write("box.dae", collada());
    const helper::ImportedMesh own = helper::import_meshes({{.file = file}}).meshes[0];
    ASSERT_TRUE(own.accepted) << own.reason;
    EXPECT_EQ(own.unit_from, "file");
    EXPECT_DOUBLE_EQ(own.metres_per_unit, 0.01);
    EXPECT_LT((extent(own.stones[0]) - Eigen::Vector3d(0.01, 0.03, 0.02)).norm(), 1e-12) << "y of the file is up";

    const helper::ImportedMesh said =
        helper::import_meshes({{.file = file, .metres_per_unit = 0.001, .up = 'z'}}).meshes[0];
    ASSERT_TRUE(said.accepted) << said.reason;
    EXPECT_EQ(said.unit_from, "option");
    EXPECT_LT((extent(said.stones[0]) - Eigen::Vector3d(0.001, 0.002, 0.003)).norm(), 1e-12);
    ASSERT_FALSE(said.repairs.empty());
    EXPECT_NE(said.repairs.back().text.find("the option says 0.001 m and is used"), std::string::npos);

    const helper::ImportedMesh assumed =
        helper::import_meshes({{.file = folder.write("b.obj", mesh::to_obj({unit_cube()}, {}))}}).meshes[0];
    EXPECT_EQ(assumed.unit_from, "assumed");
    EXPECT_EQ(assumed.metres_per_unit, 1);
}

TEST(Frame, WhatBecomesAStoneIsChosen)
{
    mesh::PolygonSurface two = unit_cube();  // two boxes in one object
    const mesh::PolygonSurface second = box({3, 0, 0}, {4, 1, 1});
    two.vertices.insert(two.vertices.end(), second.vertices.begin(), second.vertices.end());
    for (std::vector<int> face : second.faces) {
        for (int& v : face) v += 8;
        two.faces.push_back(face);
    }
    const TemporaryFolder folder;
    const auto file = folder.write("two.obj", mesh::to_obj({two}, {}));
    EXPECT_EQ(helper::import_meshes({{.file = file}}).meshes[0].stones.size(), 2U);
    EXPECT_EQ(
        helper::import_meshes({{.file = file, .stones = helper::StoneLevel::component}}).meshes[0].stones.size(),
        2U);
    const helper::ImportedMesh object =
        helper::import_meshes({{.file = file, .stones = helper::StoneLevel::object}}).meshes[0];
    EXPECT_FALSE(object.accepted);
    EXPECT_NE(object.reason.find("2 separate shells"), std::string::npos) << object.reason;
}

}  // namespace
}  // namespace voussoir::importers
