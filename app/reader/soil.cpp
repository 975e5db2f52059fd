// Layered ground as a case file gives it: layers from the surface down, cut into blocks as fine as waves need.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/reader/block_reading.h"
#include "app/reader/materials.h"
#include "importers/patterns/max_blocks.h"

namespace voussoir::app::reader
{
namespace
{

constexpr double blocks_to_wave = 10;  // of S, at the highest frequency: docs/ground.md

struct SoilLayer {
    double thickness = 0, speed = 0;  // m, m/s of S waves
    int material = 0;                 // index into Model::materials
    int rows = 1;
    double coarsest = 0;  // m, that a block may be high
};

struct Soil {
    std::string name;
    double width = 0, depth = 0;     // m, along x and y
    double surface = 0, centre = 0;  // m, height of the surface; x of the middle
    double frequency = 0;            // Hz
    int columns = 1;
    double side_columns = 0;        // m, width of the columns beside; 0: none
    double side_gap = 0;            // m, between them and the soil; 0: they touch
    std::vector<SoilLayer> layers;  // from the surface down
};

SoilLayer read_layer(YamlCursor& map, const Soil& soil, Model& model)
{
    SoilLayer layer;
    BlockMaterial material;
    material.name = fmt::format("{}_{}", soil.name, soil.layers.size() + 1);
    layer.thickness = map.quantity("thickness", words::dimension::length, words::Range::positive());
    layer.speed = map.quantity("shear_wave", words::dimension::velocity, words::Range::positive());
    material.density = read_density(map);
    material.poisson = map.quantity("poisson", words::dimension::number, {-1, 0.5, false, false});
    material.young = 2 * (1 + material.poisson) * material.density * layer.speed * layer.speed;
    if (std::optional<YamlCursor> rayleigh = map.find("rayleigh")) material.rayleigh = read_rayleigh(*rayleigh);
    if (std::optional<YamlCursor> hysteretic = map.find("hysteretic")) read_hysteretic(*hysteretic, material);
    map.reject_unknown_keys();
    const bool known = std::any_of(model.materials.begin(), model.materials.end(),
                                   [&](const BlockMaterial& other) { return other.name == material.name; });
    if (known) map.fault("a second material named " + material.name, "give the soil another name");
    layer.material = static_cast<int>(model.materials.size());
    layer.coarsest = layer.speed / soil.frequency / blocks_to_wave;
    model.materials.push_back(material);
    return layer;
}

/// How many blocks a layer is high, and why.
void settle_rows(const YamlCursor& map, const Soil& soil, SoilLayer& layer)
{
    const double rows = std::ceil(layer.thickness / layer.coarsest - 1e-9);
    if (!(rows <= importers::patterns::max_blocks))
        return map.fault(fmt::format("{:g} blocks one above the other", rows), "give a lower highest_frequency");
    layer.rows = static_cast<int>(rows);
    map.took_default(
        "blocks",
        fmt::format("{} of {:.3g} m: a tenth of the S wave of {:g} m/s at {:g} Hz is {:.3g} m", layer.rows,
                    layer.thickness / layer.rows, layer.speed, soil.frequency, layer.coarsest));
}

void read_layers(YamlCursor& map, Soil& soil, Model& model)
{
    const std::optional<YamlCursor> list = map.require("layers", "the layers from the surface down, a list");
    if (!list) return;
    if (list->is_list_of(0)) list->fault("an empty list", "give a layer");
    for (YamlCursor& item : list->items("a list of layers {thickness, shear_wave, density, poisson}")) {
        if (!item.expect_map("a layer {thickness, shear_wave, density, poisson}")) continue;
        const std::size_t faults = item.fault_count();
        SoilLayer layer = read_layer(item, soil, model);
        if (item.fault_count() == faults) settle_rows(item, soil, layer);
        soil.layers.push_back(layer);
    }
}

/// How many blocks the soil is wide: as wide as the lowest of them are high, unless the case says.
int read_columns(YamlCursor& map, const Soil& soil)
{
    if (map.find("columns")) return map.integer_or("columns", 1, 1'000'000, 1);
    double coarsest = soil.width;
    for (const SoilLayer& layer : soil.layers) coarsest = std::min(coarsest, layer.coarsest);
    const double columns = std::ceil(soil.width / coarsest - 1e-9);
    if (!(columns >= 1 && columns <= importers::patterns::max_blocks)) return 1;  // a fault already, or soon
    map.took_default("columns", fmt::format("{:g}, as wide as blocks may be high", columns));
    return static_cast<int>(columns);
}

DrawnStone stone_of(const std::string& name, const Soil& soil, Kinematics kinematics, double left, double right,
                    double low, double high)
{
    if (is_planar(kinematics)) return {name, {}, {make_rectangle({left, low}, {right, high})}};
    return {name, {make_box({left, -soil.depth / 2, low}, {right, soil.depth / 2, high})}, {}};
}

/// One row of blocks of a layer, and what lies beside it.
void draw_row(const Soil& soil, Kinematics kinematics, int number, double low, double high,
              std::vector<DrawnStone>& inside, std::vector<DrawnStone>& beside)
{
    const double left = soil.centre - soil.width / 2, step = soil.width / soil.columns;
    for (int i = 0; i < soil.columns; ++i)
        inside.push_back(stone_of(fmt::format("{}_r{}_c{}", soil.name, number, i + 1), soil, kinematics,
                                  left + i * step, left + (i + 1) * step, low, high));
    if (soil.side_columns == 0) return;
    const double right = left + soil.width;
    const double gap = soil.side_gap, far = gap + soil.side_columns;
    beside.push_back(stone_of(fmt::format("{}_r{}_left", soil.name, number), soil, kinematics, left - far,
                              left - gap, low, high));
    beside.push_back(stone_of(fmt::format("{}_r{}_right", soil.name, number), soil, kinematics, right + gap,
                              right + far, low, high));
}

void add_layers(const Soil& soil, const YamlCursor& entry, const YamlCursor& map, BlockReading& reading)
{
    double high = soil.surface;
    int number = 0;
    for (const SoilLayer& layer : soil.layers) {
        std::vector<DrawnStone> inside, beside;
        const double step = layer.thickness / layer.rows, top = high;
        for (int i = 0; i < layer.rows; ++i) {
            const double low = top - (i + 1) * step;
            draw_row(soil, reading.model.kinematics, ++number, low, high, inside, beside);
            high = low;
        }
        const auto add = [&](std::vector<DrawnStone> stones, const std::string& group) {
            if (stones.empty()) return;
            Belonging belonging{entry, {layer.material, {}}, group, {}, {importers::helper::PlacedCopy{}}};
            add_stones(std::move(stones), map, std::move(belonging),
                       "blocks are named " + soil.name + "_r1_c1, ...", reading);
        };
        add(std::move(inside), soil.name);
        add(std::move(beside), soil.name + "_sides");
    }
}

}  // namespace

void read_soil(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!map.expect_map("a soil {width, highest_frequency, layers: [...]}")) return;
    const std::size_t faults_before = reading.findings.faults.size();
    Soil soil;
    soil.name = map.find_text("name").value_or("soil");
    soil.width = map.quantity("width", words::dimension::length, words::Range::positive());
    if (is_planar(reading.model.kinematics))
        map.forbid("depth", "a planar scene has a thickness");
    else
        soil.depth = map.quantity("depth", words::dimension::length, words::Range::positive());
    soil.surface = map.quantity_or("surface", words::dimension::length, words::Range::any(), 0);
    soil.centre = map.quantity_or("centre", words::dimension::length, words::Range::any(), 0);
    soil.frequency = map.quantity("highest_frequency", words::dimension::frequency, words::Range::positive());
    read_layers(map, soil, reading.model);
    soil.columns = read_columns(map, soil);
    soil.side_columns =
        map.find_quantity("side_columns", words::dimension::length, words::Range::positive()).value_or(0);
    soil.side_gap = map.find_quantity("side_gap", words::dimension::length, words::Range::positive()).value_or(0);
    if (soil.side_gap > 0 && soil.side_columns == 0)
        map.fault("side_gap without side_columns", "give side_columns, or leave both away");
    map.reject_unknown_keys();
    entry.reject_unknown_keys();
    if (reading.findings.faults.size() > faults_before) return;
    double rows = 0;
    for (const SoilLayer& layer : soil.layers) rows += layer.rows;
    if (rows * (soil.columns + 2.0) > importers::patterns::max_blocks)
        return map.fault(
            fmt::format("{:g} blocks", rows * soil.columns),
            fmt::format("at most {}: give a lower highest_frequency", importers::patterns::max_blocks));
    add_layers(soil, entry, map, reading);
}

}  // namespace voussoir::app::reader
