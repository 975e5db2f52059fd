// The generated bridge as a model, without the way through a mesh file.
#pragma once

#include <string>

#include "importers/patterns/arch_bridge.h"
#include "tests/libdda/scenes.h"

namespace voussoir::verification
{

inline Model bridge_model(const importers::patterns::ArchBridge& bridge,
                          Kinematics kinematics = Kinematics::spatial_deformable)
{
    Model model = make_model(kinematics, {"granite", 2400, 4.5e9, 0.25}, testing::dry(30));
    for (const importers::mesh::PolygonSurface& stone : importers::patterns::arch_bridge(bridge)) {
        const int block = static_cast<int>(model.blocks.size());
        model.blocks.push_back(
            make_block(stone.name, 0, 0, {make_convex_polyhedron(stone.vertices, stone.faces, stone.name)}));
        if (stone.name.rfind("abutment", 0) == 0) testing::hold(model, block);
    }
    return model;
}

inline int block_named(const Model& model, const std::string& name)
{
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
        if (model.blocks[b].name == name) return static_cast<int>(b);
    return -1;
}

}  // namespace voussoir::verification
