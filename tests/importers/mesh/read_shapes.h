// Files of many formats for the tests of reading, written here by hand.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>

#include "importers/mesh/read_mesh.h"
#include "importers/mesh/write_obj.h"
#include "libdda/errors.h"
#include "tests/importers/shapes.h"

namespace voussoir::importers
{

/// The sentence of the refusal; empty when the file is read.
inline std::string refusal(const std::filesystem::path& file)
{
    try {
        mesh::read_mesh(file);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// Seventeen digits.
inline std::string digits(double value)
{
    std::array<char, 40> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + 40, value, std::chars_format::general, 17).ptr};
}

inline std::string digits(const Eigen::Vector3d& x)
{
    return digits(x.x()) + " " + digits(x.y()) + " " + digits(x.z());
}

template <class Number>
std::string bytes_of(Number value, bool big_endian = false)
{
    std::string bytes(sizeof(Number), '\0');
    std::memcpy(bytes.data(), &value, sizeof(Number));
    if (big_endian) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

inline std::string to_off(const mesh::PolygonSurface& surface)
{
    std::string text =
        "OFF\n" + std::to_string(surface.vertices.size()) + " " + std::to_string(surface.faces.size()) + " 0\n";
    for (const Eigen::Vector3d& x : surface.vertices) text += digits(x) + "\n";
    for (const std::vector<int>& face : surface.faces) {
        text += std::to_string(face.size());
        for (const int v : face) text += " " + std::to_string(v);
        text += "\n";
    }
    return text;
}

inline std::string to_ascii_stl(const mesh::PolygonSurface& surface, const std::string& name)
{
    std::string text = "solid " + name + "\n";
    for (const std::vector<int>& face : surface.faces) {
        text += "  facet normal 0 0 0\n    outer loop\n";
        for (const int v : face) text += "      vertex " + digits(surface.vertices[v]) + "\n";
        text += "    endloop\n  endfacet\n";
    }
    return text + "endsolid " + name + "\n";
}

inline std::string to_binary_stl(const mesh::PolygonSurface& surface, std::string header)
{
    header.resize(80, ' ');
    std::string bytes = header + bytes_of(static_cast<std::uint32_t>(surface.faces.size()));
    for (const std::vector<int>& face : surface.faces) {
        bytes += std::string(12, '\0');
        for (const int v : face)
            for (int i = 0; i < 3; ++i) bytes += bytes_of(static_cast<float>(surface.vertices[v][i]));
        bytes += std::string(2, '\0');
    }
    return bytes;
}

/// @param format ascii, binary_little_endian or binary_big_endian; coordinates are doubles
inline std::string to_ply(const mesh::PolygonSurface& surface, const std::string& format)
{
    const bool ascii = format == "ascii", big = format == "binary_big_endian";
    std::string text =
        "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(surface.vertices.size()) +
        "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
        std::to_string(surface.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Eigen::Vector3d& x : surface.vertices)
        text += ascii ? digits(x) + "\n" : bytes_of(x.x(), big) + bytes_of(x.y(), big) + bytes_of(x.z(), big);
    for (const std::vector<int>& face : surface.faces) {
        text += ascii ? std::to_string(face.size()) : bytes_of(static_cast<std::uint8_t>(face.size()), big);
        for (const int v : face) text += ascii ? " " + std::to_string(v) : bytes_of(std::int32_t{v}, big);
        if (ascii) text += "\n";
    }
    return text;
}

/// A zip archive that stores its parts as they are.
inline std::string to_zip(const std::vector<std::pair<std::string, std::string>>& parts)
{
    std::string archive, directory;
    for (const auto& [name, content] : parts) {
        std::uint32_t crc = ~std::uint32_t{0};
        for (const char c : content) {
            crc ^= static_cast<unsigned char>(c);
            for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320U : 0U);
        }
        const auto size = static_cast<std::uint32_t>(content.size());
        const std::string facts = bytes_of(std::uint16_t{20}) + bytes_of(std::uint16_t{0}) +
                                  bytes_of(std::uint16_t{0}) + bytes_of(std::uint32_t{0x21}) + bytes_of(~crc) +
                                  bytes_of(size) + bytes_of(size) +
                                  bytes_of(static_cast<std::uint16_t>(name.size())) + bytes_of(std::uint16_t{0});
        directory += "PK\x01\x02" + bytes_of(std::uint16_t{20}) + facts + std::string(10, '\0') +
                     bytes_of(static_cast<std::uint32_t>(archive.size())) + name;
        archive += "PK\x03\x04" + facts + name + content;
    }
    const auto count = static_cast<std::uint16_t>(parts.size());
    return archive + directory + "PK\x05\x06" + std::string(4, '\0') + bytes_of(count) + bytes_of(count) +
           bytes_of(static_cast<std::uint32_t>(directory.size())) +
           bytes_of(static_cast<std::uint32_t>(archive.size())) + std::string(2, '\0');
}

/// The signed volume of a closed surface, by fans.
inline double volume_of(const mesh::PolygonSurface& surface)
{
    double six = 0;
    const Eigen::Vector3d& o = surface.vertices[0];
    for (const std::vector<int>& face : surface.faces)
        for (std::size_t i = 1; i + 1 < face.size(); ++i)
            six += (surface.vertices[face[0]] - o)
                       .dot((surface.vertices[face[i]] - o).cross(surface.vertices[face[i + 1]] - o));
    return six / 6;
}

inline Eigen::Vector3d lowest_of(const mesh::PolygonSurface& surface)
{
    Eigen::Vector3d lower = surface.vertices[0];
    for (const Eigen::Vector3d& x : surface.vertices) lower = lower.cwiseMin(x);
    return lower;
}

}  // namespace voussoir::importers
