// Files of the formats that only assimp reads, written here: polygons with a name, placed by a transform where the
// format has transforms, else where they stand.
#pragma once

#include "tests/importers/mesh/read_shapes.h"

namespace voussoir::importers
{

/// A surface in its own axes, and where it is: metres, z up.
struct PlacedSurface {
    mesh::PolygonSurface surface;
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();
};

inline mesh::PolygonSurface moved(const PlacedSurface& stone)
{
    mesh::PolygonSurface surface = stone.surface;
    for (Eigen::Vector3d& x : surface.vertices) x = stone.placement * x;
    return surface;
}

/// Text between numbers and nothing after the last.
template <class Items, class Words>
std::string joined(const Items& items, const std::string& separator, const Words& words_of)
{
    std::string text;
    for (const auto& item : items) text += (text.empty() ? "" : separator) + words_of(item);
    return text;
}

inline std::string listed(const Eigen::Vector3d& x)
{
    return digits(x.x()) + "," + digits(x.y()) + "," + digits(x.z());
}

/// Degrees about x, then y, then z.
inline Eigen::Vector3d turns_of(const Eigen::Affine3d& placement)
{
    const Eigen::Matrix3d r = placement.linear();
    const double degree = 3.14159265358979323846 / 180;
    return Eigen::Vector3d(std::atan2(r(2, 1), r(2, 2)), std::asin(-r(2, 0)), std::atan2(r(1, 0), r(0, 0))) /
           degree;
}

/// ASCII FBX 7.3. @param unit cm
inline std::string to_fbx(const std::vector<PlacedSurface>& stones, double unit)
{
    std::string objects, connections;
    for (std::size_t i = 0; i < stones.size(); ++i) {
        const mesh::PolygonSurface& s = stones[i].surface;
        const std::string geometry = std::to_string(1001 + i), model = std::to_string(2001 + i);
        const std::string indices = joined(s.faces, ",", [](std::vector<int> face) {
            face.back() = ~face.back();
            return joined(face, ",", [](int v) { return std::to_string(v); });
        });
        objects += "\tGeometry: " + geometry + ", \"Geometry::" + s.name + "\", \"Mesh\" {\n\t\tVertices: *" +
                   std::to_string(3 * s.vertices.size()) +
                   " {\n\t\t\ta: " + joined(s.vertices, ",", [](const Eigen::Vector3d& x) { return listed(x); }) +
                   "\n\t\t}\n\t\tPolygonVertexIndex: *" +
                   std::to_string(1 + std::count(indices.begin(), indices.end(), ',')) +
                   " {\n\t\t\ta: " + indices + "\n\t\t}\n\t}\n\tModel: " + model + ", \"Model::" + s.name +
                   "\", \"Mesh\" {\n\t\tVersion: 232\n\t\tProperties70:  {\n\t\t\tP: \"Lcl Translation\", \"Lcl "
                   "Translation\", \"\", \"A\"," +
                   listed(stones[i].placement.translation()) +
                   "\n\t\t\tP: \"Lcl Rotation\", \"Lcl Rotation\", \"\", \"A\"," +
                   listed(turns_of(stones[i].placement)) + "\n\t\t}\n\t}\n";
        connections += "\tC: \"OO\"," + model + ",0\n\tC: \"OO\"," + geometry + "," + model + "\n";
    }
    return "; FBX 7.3.0 project file\nFBXHeaderExtension:  {\n\tFBXHeaderVersion: 1003\n\tFBXVersion: 7300\n}\n"
           "GlobalSettings:  {\n\tVersion: 1000\n\tProperties70:  {\n\t\tP: \"UpAxis\", \"int\", \"Integer\", "
           "\"\",2\n"
           "\t\tP: \"UpAxisSign\", \"int\", \"Integer\", \"\",1\n\t\tP: \"UnitScaleFactor\", \"double\", "
           "\"Number\", "
           "\"\"," +
           digits(unit) + "\n\t}\n}\nObjects:  {\n" + objects + "}\nConnections:  {\n" + connections + "}\n";
}

/// X3D: y is up.
inline std::string to_x3d(const std::vector<PlacedSurface>& stones)
{
    std::string scene;
    for (const PlacedSurface& stone : stones) {
        const Eigen::AngleAxisd turn(stone.placement.rotation());
        const Eigen::Vector3d& axis = turn.axis();
        scene += "<Transform DEF=\"" + stone.surface.name + "\" translation=\"" +
                 digits(stone.placement.translation()) + "\" rotation=\"" + digits(axis) + " " +
                 digits(turn.angle()) + "\"><Shape><IndexedFaceSet coordIndex=\"" +
                 joined(stone.surface.faces, " ",
                        [](const std::vector<int>& face) {
                            return joined(face, " ", [](int v) { return std::to_string(v); }) + " -1";
                        }) +
                 "\"><Coordinate point=\"" +
                 joined(stone.surface.vertices, " ", [](const Eigen::Vector3d& x) { return digits(x); }) +
                 "\"/></IndexedFaceSet></Shape></Transform>\n";
    }
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<X3D profile=\"Interchange\" version=\"3.3\"><Scene>"
           "<Transform rotation=\"1 0 0 -1.5707963267948966\">\n" +
           scene + "</Transform></Scene></X3D>\n";
}

inline std::string iff_chunk(const std::string& name, std::string content)
{
    if (content.size() % 2 != 0) content.push_back('\0');
    return name + bytes_of(static_cast<std::uint32_t>(content.size()), true) + content;
}

/// LWO2, a layer for each stone: left-handed, y is up, faces run clockwise.
inline std::string to_lwo(const std::vector<PlacedSurface>& stones)
{
    std::string chunks = iff_chunk("TAGS", std::string("stone\0", 6));
    for (std::size_t i = 0; i < stones.size(); ++i) {
        const mesh::PolygonSurface s = moved(stones[i]);
        std::string points, polygons = "FACE", tags = "SURF";
        for (const Eigen::Vector3d& x : s.vertices)
            for (const double c : {x.x(), x.z(), x.y()}) points += bytes_of(static_cast<float>(c), true);
        for (std::size_t f = 0; f < s.faces.size(); ++f) {
            polygons += bytes_of(static_cast<std::uint16_t>(s.faces[f].size()), true);
            for (auto v = s.faces[f].rbegin(); v != s.faces[f].rend(); ++v)
                polygons += bytes_of(static_cast<std::uint16_t>(*v), true);
            tags += bytes_of(static_cast<std::uint16_t>(f), true) + bytes_of(std::uint16_t{0}, true);
        }
        chunks += iff_chunk("LAYR", bytes_of(static_cast<std::uint16_t>(i), true) + std::string(14, '\0') +
                                        s.name + '\0') +
                  iff_chunk("PNTS", points) + iff_chunk("POLS", polygons) + iff_chunk("PTAG", tags);
    }
    return iff_chunk("FORM", "LWO2" + chunks);
}

/// OpenGEX: z is up. @param metres the unit
inline std::string to_ogex(const std::vector<PlacedSurface>& stones, double metres)
{
    const auto triple = [](const Eigen::Vector3d& x) { return "{" + listed(x) + "}"; };
    std::string nodes, objects;
    for (std::size_t i = 0; i < stones.size(); ++i) {
        const mesh::PolygonSurface s = triangulated(stones[i].surface);
        const std::string number = std::to_string(i + 1);
        const Eigen::Matrix4d& m = stones[i].placement.matrix();
        nodes += "GeometryNode $node" + number + "\n{\n\tName {string {\"" + s.name +
                 "\"}}\n\tObjectRef {ref {$geometry" + number +
                 "}}\n\tTransform\n\t{\n\t\tfloat[16]\n\t\t{\n\t\t\t{" +
                 joined(m.reshaped(), ", ", [](double entry) { return digits(entry); }) + "}\n\t\t}\n\t}\n}\n\n";
        objects += "GeometryObject $geometry" + number +
                   "\n{\n\tMesh (primitive = \"triangles\")\n\t{\n\t\tVertexArray (attrib = "
                   "\"position\")\n\t\t{\n\t\t\tfloat[3]\n\t\t\t{\n\t\t\t\t" +
                   joined(s.vertices, ", ", triple) +
                   "\n\t\t\t}\n\t\t}\n\n\t\tIndexArray\n\t\t{\n\t\t\tunsigned_int32[3]\n\t\t\t{\n\t\t\t\t" +
                   joined(s.faces, ", ",
                          [](const std::vector<int>& face) {
                              return "{" + joined(face, ", ", [](int v) { return std::to_string(v); }) + "}";
                          }) +
                   "\n\t\t\t}\n\t\t}\n\t}\n}\n\n";
    }
    return "Metric (key = \"distance\") {float {" + digits(metres) +
           "}}\nMetric (key = \"angle\") {float {1}}\nMetric (key = \"time\") {float {1}}\n"
           "Metric (key = \"up\") {string {\"z\"}}\n\n" +
           nodes + objects;
}

inline std::string chunk_3ds(int kind, const std::string& content)
{
    return bytes_of(static_cast<std::uint16_t>(kind)) + bytes_of(static_cast<std::uint32_t>(6 + content.size())) +
           content;
}

inline std::string to_3ds(const std::vector<PlacedSurface>& stones)
{
    std::string objects;
    for (const PlacedSurface& stone : stones) {
        const mesh::PolygonSurface s = triangulated(moved(stone));
        std::string points = bytes_of(static_cast<std::uint16_t>(s.vertices.size()));
        std::string faces = bytes_of(static_cast<std::uint16_t>(s.faces.size()));
        for (const Eigen::Vector3d& x : s.vertices)
            for (int i = 0; i < 3; ++i) points += bytes_of(static_cast<float>(x[i]));
        for (const std::vector<int>& face : s.faces) {
            for (const int v : face) faces += bytes_of(static_cast<std::uint16_t>(v));
            faces += bytes_of(std::uint16_t{7});
        }
        objects += chunk_3ds(
            0x4000, s.name + '\0' + chunk_3ds(0x4100, chunk_3ds(0x4110, points) + chunk_3ds(0x4120, faces)));
    }
    return chunk_3ds(0x4D4D, chunk_3ds(0x3D3D, objects));
}

/// @param unit as AMF names it, of `metres`
inline std::string to_amf(const std::vector<PlacedSurface>& stones, const std::string& unit, double metres)
{
    std::string objects;
    for (std::size_t i = 0; i < stones.size(); ++i) {
        const mesh::PolygonSurface s = triangulated(moved(stones[i]));
        objects += "<object id=\"" + std::to_string(i + 1) + "\"><metadata type=\"name\">" + s.name +
                   "</metadata><mesh><vertices>";
        for (const Eigen::Vector3d& x : s.vertices)
            objects += "<vertex><coordinates><x>" + digits(x.x() / metres) + "</x><y>" + digits(x.y() / metres) +
                       "</y><z>" + digits(x.z() / metres) + "</z></coordinates></vertex>\n";
        objects += "</vertices><volume>";
        for (const std::vector<int>& face : s.faces)
            objects += "<triangle><v1>" + std::to_string(face[0]) + "</v1><v2>" + std::to_string(face[1]) +
                       "</v2><v3>" + std::to_string(face[2]) + "</v3></triangle>\n";
        objects += "</volume></mesh></object>\n";
    }
    return "<?xml version=\"1.0\"?>\n<amf unit=\"" + unit + "\">\n" + objects + "</amf>\n";
}

}  // namespace voussoir::importers
