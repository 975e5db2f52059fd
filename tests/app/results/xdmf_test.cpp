// results.xdmf is well-formed and agrees with results.h5 in every dimension.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>

#include "app/results/results_reader.h"
#include "app/results/results_writer.h"
#include "app/results/xdmf.h"
#include "tests/app/results/synthetic.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::results
{
namespace
{

std::string text_of(const std::filesystem::path& path)
{
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<std::uint64_t> numbers(const std::string& text)
{
    std::istringstream stream(text);
    return {std::istream_iterator<std::uint64_t>(stream), std::istream_iterator<std::uint64_t>()};
}

struct Element {
    std::string name, text;
    std::map<std::string, std::string> attributes;
    std::vector<Element> children;
};

/// A strict reader of the XML we write: tags must nest, attributes be quoted, nothing else stand in tags.
Element parse(const std::string& xml)
{
    const std::regex tag(R"re(<(/?)([A-Za-z]+)((?:\s+[A-Za-z]+="[^"<]*")*)\s*(/?)>)re");
    const std::regex attribute(R"re(([A-Za-z]+)="([^"]*)")re");
    const std::size_t start = xml.find("?>") + 2;
    std::vector<Element> open(1);
    std::size_t at = start;
    for (std::sregex_iterator m(xml.begin() + static_cast<std::ptrdiff_t>(start), xml.end(), tag), end; m != end;
         ++m) {
        const std::string between = xml.substr(at, start + m->position() - at);
        if (between.find_first_of("<>") != std::string::npos) throw std::runtime_error("stray tag: " + between);
        open.back().text += between;
        at = start + m->position() + m->length();
        if ((*m)[1].length() > 0) {
            if (open.size() < 2 || open.back().name != (*m)[2]) throw std::runtime_error("unbalanced");
            Element closed = open.back();
            open.pop_back();
            open.back().children.push_back(closed);
            continue;
        }
        Element element;
        element.name = (*m)[2];
        const std::string list = (*m)[3];
        for (std::sregex_iterator a(list.begin(), list.end(), attribute); a != end; ++a) {
            element.attributes[(*a)[1]] = (*a)[2];
        }
        if ((*m)[4].length() > 0)
            open.back().children.push_back(element);
        else
            open.push_back(element);
    }
    if (open.size() != 1 || xml.find_first_not_of(" \n", at) != std::string::npos) {
        throw std::runtime_error("not closed");
    }
    return open[0];
}

void all_named(const Element& element, const std::string& name, std::vector<Element>& found)
{
    if (element.name == name) found.push_back(element);
    for (const Element& child : element.children) all_named(child, name, found);
}

std::vector<Element> all_named(const Element& element, const std::string& name)
{
    std::vector<Element> found;
    all_named(element, name, found);
    return found;
}

Extents dataset_extents(const Hdf5File& file, const Element& item)
{
    const std::string text = std::regex_replace(item.text, std::regex("^\\s+|\\s+$"), "");
    EXPECT_EQ(text.substr(0, 11), "results.h5:");
    return file.extents(text.substr(11));
}

class Xdmf : public testing::TestWithParam<Kinematics>
{
 protected:
    void SetUp() override
    {
        Case the_case = synthetic::arch(GetParam(), 9);
        the_case.title = "An <arch> & its \"keystone\"";
        ResultsWriter writer(the_case, folder.path());
        for (const double time : {0.0, 0.5, 1.0, 1.5}) writer.frame(synthetic::swaying(the_case, time), {});
        writer.finish(synthetic::swaying(the_case, 1.5), {}, {0, 0});
        root = parse(text_of(folder.path() / "results.xdmf"));
    }
    TemporaryFolder folder;
    Element root;
};

TEST_P(Xdmf, OneMomentForEachFrameWithItsTimeInEveryGrid)
{
    const Element course = all_named(root, "Grid").at(0);
    std::vector<double> times;
    for (const Element& moment : course.children) {
        ASSERT_EQ(moment.attributes.at("CollectionType"), "Spatial");
        times.push_back(std::stod(moment.children.at(0).attributes.at("Value")));
        for (const Element& time : all_named(moment, "Time"))
            EXPECT_EQ(std::stod(time.attributes.at("Value")), times.back());
    }
    EXPECT_EQ(times, (std::vector<double>{0, 0.5, 1, 1.5}));
}

/// The first grid of this name in a moment.
Element grid_named(const Element& root, const std::string& name, std::size_t moment)
{
    const Element course = all_named(root, "Grid").at(0);
    for (const Element& grid : all_named(course.children.at(moment), "Grid"))
        if (grid.attributes.at("Name") == name) return grid;
    throw std::runtime_error("no grid " + name);
}

TEST_P(Xdmf, BlocksJointsAndContacts)
{
    const Hdf5File file = Hdf5File::open(folder.path() / "results.h5");
    EXPECT_EQ(all_named(grid_named(root, "blocks", 3), "Attribute").size(), is_deformable(GetParam()) ? 4U : 2U);
    const Element joints = grid_named(root, "joints", 3), contacts = grid_named(root, "contacts 0", 3);
    EXPECT_EQ(all_named(joints, "Topology").at(0).attributes.at("NumberOfElements"),
              std::to_string(file.extents("/joints/area")[0]));
    EXPECT_EQ(all_named(contacts, "Topology").at(0).attributes.at("NumberOfElements"),
              std::to_string(file.read_rows<std::int64_t>("/frames/contacts/rows", 3, 1)[1]));
}

TEST_P(Xdmf, EveryDimensionIsThatOfTheFile)
{
    const Hdf5File file = Hdf5File::open(folder.path() / "results.h5");
    std::size_t datasets = 0;
    for (const Element& item : all_named(root, "DataItem")) {
        const auto format = item.attributes.find("Format");
        if (format == item.attributes.end() || format->second != "HDF") continue;
        EXPECT_EQ(numbers(item.attributes.at("Dimensions")), dataset_extents(file, item));
        ++datasets;
    }
    EXPECT_GE(datasets, 12U);
}

/// Numbers of a kind at an address of the results file.
template <typename T>
std::vector<T> at_address(const std::filesystem::path& results, const Element& item)
{
    std::uint64_t count = 1;
    for (const std::uint64_t n : numbers(item.attributes.at("Dimensions"))) count *= n;
    std::vector<T> values(count);
    std::ifstream stream(results, std::ios::binary);
    stream.seekg(std::stoll(item.attributes.at("Seek")));
    stream.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
    EXPECT_TRUE(stream) << "within the file";
    return values;
}

TEST_P(Xdmf, AtEveryAddressAreTheValuesOfTheFrame)
{
    const std::filesystem::path results = folder.path() / "results.h5";
    const Hdf5File file = Hdf5File::open(results);
    for (std::size_t frame = 0; frame < 4; ++frame) {
        const Element blocks = grid_named(root, "blocks", frame), joints = grid_named(root, "joints", frame);
        EXPECT_EQ(at_address<float>(results, all_named(all_named(blocks, "Geometry").at(0), "DataItem").at(0)),
                  file.read_rows<float>("/frames/positions", frame, 1));
        EXPECT_EQ(at_address<float>(results, all_named(all_named(blocks, "Attribute").at(1), "DataItem").at(0)),
                  file.read_rows<float>("/frames/face_displacement", frame, 1));
        EXPECT_EQ(at_address<float>(results, all_named(all_named(joints, "Attribute").at(0), "DataItem").at(0)),
                  file.read_rows<float>("/frames/joints/opening", frame, 1));
        const auto rows = file.read_rows<std::int64_t>("/frames/contacts/rows", frame, 1);
        const Element contacts = grid_named(root, "contacts 0", frame);
        EXPECT_EQ(at_address<double>(results, all_named(all_named(contacts, "Attribute").at(0), "DataItem").at(0)),
                  file.read_rows<double>("/frames/contacts/force", static_cast<std::uint64_t>(rows[0]),
                                         static_cast<std::uint64_t>(rows[1])));
        const auto indices =
            at_address<std::int32_t>(results, all_named(all_named(contacts, "Topology").at(0), "DataItem").at(0));
        for (std::size_t i = 0; i < indices.size(); ++i) EXPECT_EQ(indices[i], static_cast<std::int32_t>(i));
    }
}

TEST(XdmfTimes, OfTwoStatesOfOneTimeTheLastIsShown)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(Kinematics::spatial_rigid, 9);
    ResultsWriter writer(the_case, folder.path());
    for (const double time : {0.0, 0.0, 0.5}) writer.frame(synthetic::swaying(the_case, time), {});
    writer.finish(synthetic::swaying(the_case, 0.5), {}, {0, 0});
    const Element root = parse(text_of(folder.path() / "results.xdmf"));
    const Element course = all_named(root, "Grid").at(0);
    ASSERT_EQ(course.children.size(), 2U);
    EXPECT_EQ(course.children[0].attributes.at("Name"), "frame 1");
    EXPECT_EQ(course.children[1].attributes.at("Name"), "frame 2");
}

TEST(XdmfPieces, ContactsThatDoNotFollowEachOtherAreSeveralGrids)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(Kinematics::spatial_rigid, 90);
    ResultsWriter writer(the_case, folder.path());
    for (int i = 0; i < 30; ++i) writer.frame(synthetic::swaying(the_case, 0.01 * i), {});
    writer.finish(synthetic::swaying(the_case, 0.3), {}, {0, 0});
    const Element root = parse(text_of(folder.path() / "results.xdmf"));
    const Hdf5File file = Hdf5File::open(folder.path() / "results.h5");
    std::uint64_t told = 0, grids = 0;
    for (const Element& grid : all_named(root, "Grid")) {
        if (grid.attributes.at("Name").rfind("contacts", 0) != 0) continue;
        const Element force = all_named(all_named(grid, "Attribute").at(0), "DataItem").at(0);
        const auto values = at_address<double>(folder.path() / "results.h5", force);
        EXPECT_EQ(values, file.read_rows<double>("/frames/contacts/force", told, values.size() / 3));
        told += values.size() / 3;
        ++grids;
    }
    EXPECT_EQ(told, file.extents("/frames/contacts/pair")[0]);
    EXPECT_GT(grids, 30U) << "some frame's contacts lie in two places";
}

TEST_P(Xdmf, TheTopologyHoldsAllFacesAndOnlyTheirVertices)
{
    const Hdf5File file = Hdf5File::open(folder.path() / "results.h5");
    const std::vector<std::int32_t> cells = file.read<std::int32_t>("/model/mesh/xdmf_topology");
    const Element topology = all_named(root, "Topology").at(0);
    const std::uint64_t vertices = file.extents("/frames/positions")[1];
    std::size_t faces = 0;
    for (std::size_t i = 0; i < cells.size(); i += 2 + cells[i + 1], ++faces) {
        ASSERT_EQ(cells[i], 3);
        for (int corner = 0; corner < cells[i + 1]; ++corner) {
            ASSERT_LT(static_cast<std::uint64_t>(cells.at(i + 2 + corner)), vertices);
        }
    }
    EXPECT_EQ(std::to_string(faces), topology.attributes.at("NumberOfElements"));
    EXPECT_EQ(faces, is_planar(GetParam()) ? 11U : 11U * 6U);
    EXPECT_EQ(all_named(root, "Geometry").at(0).attributes.at("GeometryType"),
              is_planar(GetParam()) ? "XY" : "XYZ");
}

TEST_P(Xdmf, CanBeMadeAgainFromTheResultsAlone)
{
    const std::string first = text_of(folder.path() / "results.xdmf");
    write_xdmf(folder.path() / "results.h5", folder.path() / "again.xdmf");
    EXPECT_EQ(text_of(folder.path() / "again.xdmf"), first);
}

INSTANTIATE_TEST_SUITE_P(Kinematics, Xdmf,
                         testing::Values(Kinematics::spatial_deformable, Kinematics::spatial_rigid,
                                         Kinematics::planar_deformable, Kinematics::planar_rigid));

}  // namespace
}  // namespace voussoir::app::results
