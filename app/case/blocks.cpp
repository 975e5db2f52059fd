#include "app/case/blocks.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/case/block_reading.h"
#include "app/case/nearest_word.h"
#include "app/case/overlaps.h"

namespace voussoir
{
namespace
{

int group_index(Model& model, const std::string& name)
{
    const auto at = std::find(model.groups.begin(), model.groups.end(), name);
    const auto index = at - model.groups.begin();
    if (at == model.groups.end()) model.groups.push_back(name);
    return static_cast<int>(index);
}

void refuse_overlaps(BlockReading& reading, std::size_t boxes)
{
    const std::vector<Block>& blocks = reading.model.blocks;
    for (const BlockOverlap& overlap : find_overlaps(blocks, boxes)) {
        const std::string& name_b = blocks[overlap.block_b].name;
        reading.findings.faults.push_back(
            {reading.places.at(name_b) + ": " + blocks[overlap.block_a].name + " and " + name_b,
             fmt::format("overlap by {:.3g} m", overlap.depth), "stones may touch but not overlap"});
    }
}

}  // namespace

void add_block(const std::string& name, const std::string& place, const std::string& group, int material,
               std::vector<ConvexPolyhedron> parts, BlockReading& reading)
{
    const auto [known, is_new] = reading.places.emplace(name, place);
    if (!is_new) {
        reading.findings.faults.push_back(
            {place, "a second block named " + name, "the first one is at " + known->second});
        return;
    }
    reading.model.blocks.push_back(
        make_block(name, group_index(reading.model, group), material, std::move(parts)));
}

int read_material_name(YamlCursor& entry, const std::vector<BlockMaterial>& materials)
{
    std::vector<std::string> names;
    names.reserve(materials.size());
    for (const BlockMaterial& material : materials) names.push_back(material.name);
    const std::optional<YamlCursor> value = entry.find("material");
    if (!value && names.size() == 1) {
        entry.took_default("material", names[0]);
        return 0;
    }
    if (!value) {
        entry.require("material", "a material's name");
        return 0;
    }
    const std::string name = value->as_text();
    const auto at = std::find(names.begin(), names.end(), name);
    if (at != names.end()) return static_cast<int>(at - names.begin());
    if (!name.empty()) value->fault("no material \"" + name + "\"", suggestion(name, names));
    return 0;
}

bool matches_pattern(std::string_view name, std::string_view pattern)
{
    // The last * is remembered and takes one letter more whenever the rest does not fit: no exponential search.
    std::size_t n = 0, p = 0, star = std::string_view::npos, resume = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = n;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
            ++n;
            ++p;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++resume;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

std::vector<std::string> read_blocks(YamlCursor& top, const std::filesystem::path& folder, Model& model,
                                     Findings& findings)
{
    const std::optional<YamlCursor> section = top.require("blocks", "the stones, [{mesh: stones.obj}]");
    if (!section) return {};
    BlockReading reading{folder, model, findings, {}, {}};
    std::vector<YamlCursor> entries = section->items("a list of meshes and boxes");
    if (entries.empty() && section->is_list()) section->fault("no block", "give at least one mesh or box");
    for (YamlCursor& entry : entries) {
        if (!entry.expect_map("a block {mesh: file} or {box: {...}}")) continue;
        const std::optional<YamlCursor> mesh = entry.find("mesh");
        std::optional<YamlCursor> box = entry.find("box");
        if (mesh && !box)
            read_mesh(entry, *mesh, reading);
        else if (box && !mesh)
            read_box(entry, *box, reading);
        else
            entry.fault(mesh ? "both a mesh and a box" : "neither a mesh nor a box", "give one of the two");
    }
    const std::size_t boxes = model.blocks.size();
    import_meshes(reading);
    refuse_overlaps(reading, boxes);
    std::vector<std::string> files;
    for (const MeshEntry& mesh : reading.meshes) files.push_back(mesh.name);
    return files;
}

}  // namespace voussoir
