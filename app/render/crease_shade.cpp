#include "app/render/crease_shade.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace voussoir::app::render
{
namespace
{

using Row = Eigen::Map<const Eigen::ArrayXf>;

constexpr float darkest = 0.42F;  // of the light is taken at most
constexpr float too_steep = 6;    // lengths in front for a length aside: another thing, which casts nothing
constexpr float background = 1;   // depth where nothing was drawn
constexpr std::uint32_t opaque = 255;

/// Two places on either side of a third.
struct Pair {
    int across = 0, down = 0;  // cells
    float distance = 1;        // cells
};

/// At a quarter, a half and the whole of the reach, in four directions.
std::vector<Pair> pairs_within(double reach)
{
    std::vector<Pair> pairs;
    for (const double share : {0.25, 0.5, 1.0}) {
        const int straight = std::max(1, static_cast<int>(std::lround(share * reach)));
        const int oblique = std::max(1, static_cast<int>(std::lround(share * reach / std::sqrt(2.0))));
        for (const auto& [across, down] :
             {std::array{straight, 0}, {0, straight}, {oblique, oblique}, {oblique, -oblique}})
            pairs.push_back({across, down, std::hypot(static_cast<float>(across), static_cast<float>(down))});
    }
    return pairs;
}

/// Depths with a rim of background, so that every place has neighbours.
struct Padded {
    int rim = 0, width = 0;
    std::vector<float> values;

    Row row(int y, int from, int count) const
    {
        return {values.data() + static_cast<std::size_t>(y + rim) * width + rim + from, count};
    }
};

Padded padded(const Depths& depths, int rim)
{
    Padded padded{rim, depths.width + 2 * rim, {}};
    padded.values.assign(static_cast<std::size_t>(padded.width) * (depths.height + 2 * rim), background);
    for (int y = 0; y < depths.height; ++y)
        std::copy_n(depths.values.data() + static_cast<std::size_t>(y) * depths.width, depths.width,
                    padded.values.data() + static_cast<std::size_t>(y + rim) * padded.width + rim);
    return padded;
}

/// What a difference of depths is in widths of a cell: factor / (offset - slope * depth).
struct Lengths {
    float factor = 1, offset = 1, slope = 0;
};

Lengths lengths_of(const Camera& camera, int cells_across)
{
    const Eigen::Vector3d across = camera.view_projection.row(0).head<3>(),
                          depth = camera.view_projection.row(2).head<3>(),
                          away = camera.view_projection.row(3).head<3>();
    const auto factor = static_cast<float>(across.dot(camera.right) * cells_across);
    if (!(away.norm() > 0.5)) return {factor, static_cast<float>(depth.norm()), 0};
    return {factor, static_cast<float>(depth.dot(away) / away.squaredNorm()) + 1, 2};
}

}  // namespace

Shade crease_shade(const Depths& depths, const Camera& camera, double reach)
{
    const std::vector<Pair> pairs = pairs_within(reach / Depths::cell);
    const Padded from = padded(depths, pairs[pairs.size() - 4].across);
    const Lengths lengths = lengths_of(camera, depths.width);
    Shade shade{depths.width, depths.height, {}};
    shade.light.resize(depths.values.size());
    const int count = depths.width;
    Eigen::ArrayXf scale(count), hidden(count), depth(count);
    for (int y = 0; y < depths.height; ++y) {
        const Row here = from.row(y, 0, count);
        scale = 0.5F * lengths.factor / (lengths.offset - lengths.slope * here);
        hidden.setZero();
        for (const Pair& pair : pairs) {
            depth = (2 * here - from.row(y + pair.down, pair.across, count) -
                     from.row(y - pair.down, -pair.across, count)) *
                    scale / pair.distance;
            hidden += (depth * (1 - depth / too_steep)).max(0);
        }
        const Eigen::ArrayXf light = 1 - darkest * (hidden / static_cast<float>(pairs.size())).min(1);
        Eigen::Map<Eigen::ArrayXf>(shade.light.data() + static_cast<std::size_t>(y) * count, count) =
            (here < background).select(light, 1);
    }
    return shade;
}

void darken(Image& image, const Shade& shade)
{
    static_assert(Depths::cell == 2);
    constexpr std::uint32_t even = 0x00FF00FFU;
    constexpr float near = 0.75F, far = 0.25F, whole = 256;  // linear between the middles of cells
    const auto beside = [](int pixel, int cells) {
        return std::clamp(pixel / 2 + pixel % 2 * 2 - 1, 0, cells - 1);
    };
    std::vector<float> light(static_cast<std::size_t>(shade.width));  // of one row of pixels
    for (int y = 0; y < image.height; ++y) {
        const float* row = shade.light.data() + static_cast<std::size_t>(y / 2) * shade.width;
        const float* other = shade.light.data() + static_cast<std::size_t>(beside(y, shade.height)) * shade.width;
        for (int i = 0; i < shade.width; ++i) light[i] = whole * (near * row[i] + far * other[i]);
        std::uint32_t* pixels = image.pixels.data() + static_cast<std::size_t>(y) * image.width;
        for (int x = 0; x < image.width; ++x) {
            const std::uint32_t pixel = pixels[x];
            if (pixel >> 24U != opaque) continue;
            const auto share =
                static_cast<std::uint32_t>(near * light[x / 2] + far * light[beside(x, shade.width)]);
            pixels[x] = ((pixel & even) * share >> 8U & even) | ((pixel >> 8U & 255U) * share & 255U << 8U) |
                        opaque << 24U;
        }
    }
}

}  // namespace voussoir::app::render
