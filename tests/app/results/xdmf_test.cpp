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

TEST_P(Xdmf, OneGridForEachFrameWithItsTime)
{
    std::vector<double> times;
    for (const Element& time : all_named(root, "Time")) times.push_back(std::stod(time.attributes.at("Value")));
    EXPECT_EQ(times, (std::vector<double>{0, 0.5, 1, 1.5}));
    EXPECT_EQ(all_named(root, "Grid").size(), 5U);
    const std::size_t fields = is_deformable(GetParam()) ? 4 : 2;
    EXPECT_EQ(all_named(root, "Attribute").size(), 4 * fields);
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
    EXPECT_GE(datasets, 16U);
}

TEST_P(Xdmf, EveryHyperslabLiesInsideItsDataset)
{
    const Hdf5File file = Hdf5File::open(folder.path() / "results.h5");
    std::size_t slabs = 0;
    for (const Element& slab : all_named(root, "DataItem")) {
        if (!slab.attributes.count("ItemType")) continue;
        ++slabs;
        ASSERT_EQ(slab.children.size(), 2U);
        const Extents size = dataset_extents(file, slab.children[1]);
        const std::vector<std::uint64_t> selection = numbers(slab.children[0].text);
        const std::size_t rank = size.size();
        ASSERT_EQ(selection.size(), 3 * rank);
        EXPECT_EQ(numbers(slab.children[0].attributes.at("Dimensions")), (std::vector<std::uint64_t>{3, rank}));
        std::uint64_t selected = 1, declared = 1;
        for (std::size_t axis = 0; axis < rank; ++axis) {
            EXPECT_EQ(selection[rank + axis], 1U);
            EXPECT_LE(selection[axis] + selection[2 * rank + axis], size[axis]);
            selected *= selection[2 * rank + axis];
        }
        for (const std::uint64_t n : numbers(slab.attributes.at("Dimensions"))) declared *= n;
        EXPECT_EQ(selected, declared);
    }
    EXPECT_GT(slabs, 0U);
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
