#include "importers/mesh/write_obj.h"

#include <array>
#include <charconv>

namespace voussoir::importers::mesh
{

namespace
{

std::string shortest(double value)
{
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0);  // no "-0"
    return {buffer.data(), result.ptr};
}

}  // namespace

std::string to_obj(const std::vector<PolygonSurface>& surfaces, const std::vector<std::string>& header)
{
    std::string text;
    for (const std::string& line : header) text += "# " + line + "\n";
    std::size_t first = 1;
    for (const PolygonSurface& surface : surfaces) {
        text += "o " + surface.name + "\n";
        for (const Eigen::Vector3d& x : surface.vertices)
            text += "v " + shortest(x.x()) + " " + shortest(x.y()) + " " + shortest(x.z()) + "\n";
        for (const std::vector<int>& face : surface.faces) {
            text += "f";
            for (const int v : face) text += " " + std::to_string(first + static_cast<std::size_t>(v));
            text += "\n";
        }
        first += surface.vertices.size();
    }
    return text;
}

}  // namespace voussoir::importers::mesh
