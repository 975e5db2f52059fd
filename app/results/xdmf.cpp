#include "app/results/xdmf.h"

#include <fmt/format.h>

#include <iterator>

#include "app/results/atomic_file.h"
#include "app/results/results_reader.h"

namespace voussoir::app::results
{

namespace
{

std::string escaped(const std::string& text)
{
    std::string safe;
    for (const char c : text) {
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else if (c == '"')
            safe += "&quot;";
        else
            safe += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return safe;
}

/// Row `frame` of a dataset that grows frame by frame.
std::string row(const Hdf5File& file, const std::string& results, const std::string& dataset, std::size_t frame)
{
    const Extents all = file.extents(dataset);
    std::string start = std::to_string(frame), stride = "1", count = "1", size = std::to_string(all[0]), own;
    for (std::size_t axis = 1; axis < all.size(); ++axis) {
        start += " 0";
        stride += " 1";
        count += fmt::format(" {}", all[axis]);
        size += fmt::format(" {}", all[axis]);
        own += fmt::format("{}{}", axis > 1 ? " " : "", all[axis]);
    }
    return fmt::format(
        "          <DataItem ItemType=\"HyperSlab\" Dimensions=\"{}\">\n"
        "            <DataItem Dimensions=\"3 {}\" NumberType=\"Int\" Format=\"XML\">{} {} {}</DataItem>\n"
        "            <DataItem Dimensions=\"{}\" NumberType=\"Float\" Precision=\"4\" "
        "Format=\"HDF\">{}:{}</DataItem>\n"
        "          </DataItem>\n",
        own, all.size(), start, stride, count, size, results, dataset);
}

std::string whole(const Hdf5File& file, const std::string& results, const std::string& dataset)
{
    return fmt::format(
        "          <DataItem Dimensions=\"{}\" NumberType=\"Int\" Precision=\"4\" "
        "Format=\"HDF\">{}:{}</DataItem>\n",
        file.extents(dataset)[0], results, dataset);
}

std::string cell_attribute(const std::string& name, const std::string& data)
{
    return fmt::format(
        "        <Attribute Name=\"{}\" AttributeType=\"Scalar\" Center=\"Cell\">\n{}        </Attribute>\n", name,
        data);
}

std::string grid(const Hdf5File& file, const std::string& results, bool deformable, double time, std::size_t frame)
{
    const std::uint64_t faces = file.extents("/model/mesh/face_block")[0];
    std::string text = fmt::format("      <Grid Name=\"frame {}\" GridType=\"Uniform\">\n", frame);
    text += fmt::format("        <Time Value=\"{}\"/>\n", time);
    text += fmt::format("        <Topology TopologyType=\"Mixed\" NumberOfElements=\"{}\">\n", faces);
    text += whole(file, results, "/model/mesh/xdmf_topology");
    const bool planar = file.extents("/frames/positions").back() == 2;
    text += fmt::format("        </Topology>\n        <Geometry GeometryType=\"{}\">\n", planar ? "XY" : "XYZ");
    text += row(file, results, "/frames/positions", frame);
    text += "        </Geometry>\n";
    text += cell_attribute("block", whole(file, results, "/model/mesh/face_block"));
    text += cell_attribute("displacement relative to the ground [m]",
                           row(file, results, "/frames/face_displacement", frame));
    if (deformable) {
        text +=
            cell_attribute("least principal stress [Pa]", row(file, results, "/frames/face_least_stress", frame));
        text += cell_attribute("greatest principal stress [Pa]",
                               row(file, results, "/frames/face_greatest_stress", frame));
    }
    return text + "      </Grid>\n";
}

}  // namespace

void write_xdmf(const std::filesystem::path& results_file, const std::filesystem::path& xdmf_file)
{
    const ResultsReader reader(results_file);
    const Hdf5File file = Hdf5File::open(results_file);
    const std::string results = escaped(results_file.filename().string());
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n";
    text += fmt::format("    <Information Name=\"title\" Value=\"{}\"/>\n", escaped(reader.model.title));
    text += "    <Grid Name=\"voussoir\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
    for (std::size_t frame = 0; frame < reader.times.size(); ++frame) {
        text += grid(file, results, is_deformable(reader.model.kinematics), reader.times[frame], frame);
    }
    text += "    </Grid>\n  </Domain>\n</Xdmf>\n";
    write_atomically(xdmf_file, text);
}

}  // namespace voussoir::app::results
