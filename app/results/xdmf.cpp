#include "app/results/xdmf.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iterator>

#include "app/results/atomic_file.h"
#include "app/results/results_reader.h"
#include "app/words/xml_text.h"

namespace voussoir::app::results
{

namespace
{

/// The file that is described, and its name as XML.
struct Described {
    const Hdf5File& file;
    std::string name;
    bool planar = false, deformable = false;
};

struct Element {
    const char* number_type;
    int bytes;
};

constexpr Element single{"Float", 4}, real{"Float", 8}, integer{"Int", 4};

/// Values at an address of the file. ParaView's readers of XDMF 3 know no part of a dataset, but of a file they
/// do.
std::string values_at(const Described& of, std::uint64_t address, const std::string& dimensions, Element element)
{
    constexpr const char* endian = std::endian::native == std::endian::little ? "Little" : "Big";
    return fmt::format(
        "          <DataItem Dimensions=\"{}\" NumberType=\"{}\" Precision=\"{}\" Format=\"Binary\" Endian=\"{}\" "
        "Seek=\"{}\">{}</DataItem>\n",
        dimensions, element.number_type, element.bytes, endian, address, of.name);
}

/// Row `frame` of a dataset that grows frame by frame.
std::string row(const Described& of, const std::string& dataset, std::size_t frame, Element element)
{
    const Extents all = of.file.extents(dataset);
    std::string dimensions;
    std::uint64_t bytes = element.bytes;
    for (std::size_t axis = 1; axis < all.size(); ++axis) {
        dimensions += fmt::format("{}{}", axis > 1 ? " " : "", all[axis]);
        bytes *= all[axis];
    }
    return values_at(of, of.file.rows_in_file(dataset, frame, bytes).address, dimensions, element);
}

/// A dataset as a whole.
std::string whole(const Described& of, const std::string& dataset, Element element)
{
    std::string dimensions;
    for (const std::uint64_t extent : of.file.extents(dataset))
        dimensions += (dimensions.empty() ? "" : " ") + std::to_string(extent);
    return fmt::format(
        "          <DataItem Dimensions=\"{}\" NumberType=\"{}\" Precision=\"{}\" "
        "Format=\"HDF\">{}:{}</DataItem>\n",
        dimensions, element.number_type, element.bytes, of.name, dataset);
}

std::string attribute(const std::string& name, const std::string& data, const char* centre,
                      const char* type = "Scalar")
{
    return fmt::format(
        "        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">\n{}        </Attribute>\n", name, type,
        centre, data);
}

std::string geometry(const Described& of, const std::string& data)
{
    return fmt::format("        <Geometry GeometryType=\"{}\">\n{}        </Geometry>\n", of.planar ? "XY" : "XYZ",
                       data);
}

/// A grid with its time, whose parts are in `content`.
std::string uniform_grid(const std::string& name, double time, const std::string& content)
{
    return fmt::format(
        "      <Grid Name=\"{}\" GridType=\"Uniform\">\n        <Time Value=\"{}\"/>\n{}      </Grid>\n", name,
        time, content);
}

/// The faces of all blocks.
std::string blocks_grid(const Described& of, double time, std::size_t frame)
{
    std::string text = fmt::format("        <Topology TopologyType=\"Mixed\" NumberOfElements=\"{}\">\n",
                                   of.file.extents("/model/mesh/face_block")[0]);
    text += whole(of, "/model/mesh/xdmf_topology", integer) + "        </Topology>\n";
    text += geometry(of, row(of, "/frames/positions", frame, single));
    text += attribute("block", whole(of, "/model/mesh/face_block", integer), "Cell");
    const auto field = [&](const char* name, const char* dataset) {
        text += attribute(name, row(of, dataset, frame, single), "Cell");
    };
    field("displacement relative to the foot [m]", "/frames/face_displacement");
    if (of.deformable) {
        field("least principal stress [Pa]", "/frames/face_least_stress");
        field("greatest principal stress [Pa]", "/frames/face_greatest_stress");
    }
    return uniform_grid("blocks", time, text);
}

/// `count` points, each its own cell.
std::string points(const Described& of, std::uint64_t count)
{
    const RowsInFile indices = of.file.rows_in_file("/frames/contacts/indices", 0, integer.bytes);
    return fmt::format(
               "        <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\" NodesPerElement=\"1\">\n",
               count) +
           values_at(of, indices.address, std::to_string(count), integer) + "        </Topology>\n";
}

/// The joints of the start of the run, at their places of then.
std::string joints_grid(const Described& of, double time, std::size_t frame)
{
    std::string text =
        points(of, of.file.extents("/joints/area")[0]) + geometry(of, whole(of, "/joints/centre", real));
    for (const auto& [name, dataset] : {std::pair{"opening [m]", "opening"},
                                        {"largest slip [m]", "largest_slip"},
                                        {"normal force [N]", "normal_force"},
                                        {"shear force [N]", "shear_force"}})
        text += attribute(name, row(of, std::string("/frames/joints/") + dataset, frame, single), "Node");
    return uniform_grid("joints", time, text);
}

/// The contacts of a frame; where their rows do not follow each other in the file, in several pieces.
std::string contacts_grids(const Described& of, double time, std::size_t frame)
{
    const auto span = of.file.read_rows<std::int64_t>("/frames/contacts/rows", frame, 1);
    const std::uint64_t dimension = of.planar ? 2 : 3, first = static_cast<std::uint64_t>(span.at(0)),
                        end = first + static_cast<std::uint64_t>(span.at(1));
    std::string grids;
    for (std::uint64_t at = first; at < end;) {
        std::uint64_t count = end - at;
        for (const char* name : {"centre", "force", "normal"})
            count = std::min(
                count, of.file.rows_in_file(std::string("/frames/contacts/") + name, at, 8 * dimension).count);
        for (const char* name : {"normal_force", "area", "closed_area"})
            count = std::min(count, of.file.rows_in_file(std::string("/frames/contacts/") + name, at, 8).count);
        const auto data = [&](const char* name, std::uint64_t columns) {
            const RowsInFile rows = of.file.rows_in_file(std::string("/frames/contacts/") + name, at, 8 * columns);
            return values_at(of, rows.address,
                             columns == 1 ? std::to_string(count) : fmt::format("{} {}", count, columns), real);
        };
        std::string text = points(of, count) + geometry(of, data("centre", dimension));
        const char* vector = of.planar ? "Matrix" : "Vector";  // of two components there are no vectors
        text += attribute("force on the first block [N]", data("force", dimension), "Node", vector);
        text += attribute("normal", data("normal", dimension), "Node", vector);
        text += attribute("normal force [N]", data("normal_force", 1), "Node");
        text += attribute("area [m2]", data("area", 1), "Node");
        text += attribute("closed area [m2]", data("closed_area", 1), "Node");
        grids += uniform_grid(fmt::format("contacts {}", at - first), time, text);
        at += count;
    }
    return grids;
}

/// Blocks, joints and contacts of one moment.
std::string moment(const Described& of, double time, std::size_t frame)
{
    std::string text = fmt::format(
        "    <Grid Name=\"frame {}\" GridType=\"Collection\" CollectionType=\"Spatial\">\n      <Time "
        "Value=\"{}\"/>\n",
        frame, time);
    text += blocks_grid(of, time, frame);
    if (of.file.has("/joints")) text += joints_grid(of, time, frame);
    return text + contacts_grids(of, time, frame) + "    </Grid>\n";
}

}  // namespace

void write_xdmf(const std::filesystem::path& results_file, const std::filesystem::path& xdmf_file)
{
    const ResultsReader reader(results_file);
    const Hdf5File file = Hdf5File::open(results_file);
    const std::string results = words::xml_text(results_file.filename().string());
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n";
    text += fmt::format("    <Information Name=\"title\" Value=\"{}\"/>\n", words::xml_text(reader.model.title));
    text += "    <Grid Name=\"voussoir\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
    const Described described{file, results, is_planar(reader.model.kinematics),
                              is_deformable(reader.model.kinematics)};
    for (std::size_t frame = 0; frame < reader.times.size(); ++frame) {
        // Of one time, before and after a static stage, ParaView would show both states in each other.
        if (frame + 1 < reader.times.size() && !(reader.times[frame] < reader.times[frame + 1])) continue;
        text += moment(described, reader.times[frame], frame);
    }
    text += "    </Grid>\n  </Domain>\n</Xdmf>\n";
    write_atomically(xdmf_file, text);
}

}  // namespace voussoir::app::results
