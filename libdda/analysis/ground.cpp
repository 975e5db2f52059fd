#include "libdda/analysis/ground.h"

namespace voussoir
{

namespace
{

void add_ends(const Model& model, std::vector<int>& blocks)
{
    for (const ViscousBoundary& boundary : model.boundaries)
        for (const BlockFace& face : boundary.faces) blocks.push_back(face.block);
}

std::vector<int> foundations_of(const Model& model)
{
    std::vector<int> blocks;
    for (const Foundation& foundation : model.foundations) blocks.push_back(foundation.block);
    return blocks;
}

}  // namespace

std::vector<int> blocks_held_by_ground(const Model& model)
{
    std::vector<int> blocks = foundations_of(model);
    add_ends(model, blocks);
    return blocks;
}

std::vector<int> blocks_that_are_ground(const Model& model)
{
    std::vector<int> blocks = foundations_of(model);
    if (blocks.empty()) add_ends(model, blocks);
    return blocks;
}

}  // namespace voussoir
