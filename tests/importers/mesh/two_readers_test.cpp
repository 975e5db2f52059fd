// Every mesh file that both our readers and assimp read, read by both: each is the other's witness. Where they
// disagree the table below says why; an entry that holds no longer fails. assimp crashes on one of the files, so
// each is read in a process of its own.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "tests/importers/mesh/read_shapes.h"

namespace voussoir::importers
{
namespace
{

namespace fs = std::filesystem;

/// What a reader makes of a file, in metres, z up.
struct Summary {
    std::string outcome = "crash";  // or "refused", "read"
    std::size_t stones = 0, triangles = 0;
    double volume = 0;  // m3, signed, of cones from `from`
    double area = 0, rounding = 0;
    Eigen::Vector3d lower = Eigen::Vector3d::Constant(1e300), upper = -lower;
    std::string names;  // one a line
};

Eigen::Vector3d to_model(const mesh::MeshFile& file, const Eigen::Vector3d& x)
{
    const Eigen::Vector3d scaled = file.metres_per_unit.value_or(1) * x;
    return file.up == 'y' ? Eigen::Vector3d(scaled.x(), -scaled.z(), scaled.y()) : scaled;
}

Summary summary_of(const mesh::MeshFile& file, const Eigen::Vector3d* from)
{
    Summary sum;
    sum.outcome = "read";
    sum.stones = file.surfaces.size();
    sum.rounding = file.rounding * file.metres_per_unit.value_or(1);
    for (const mesh::PolygonSurface& surface : file.surfaces) {
        sum.names += surface.name + "\n";
        for (const Eigen::Vector3d& x : surface.vertices) {
            sum.lower = sum.lower.cwiseMin(to_model(file, x));
            sum.upper = sum.upper.cwiseMax(to_model(file, x));
        }
    }
    const Eigen::Vector3d o = from != nullptr ? *from : sum.lower;
    for (const mesh::PolygonSurface& surface : file.surfaces)
        for (const std::vector<int>& face : surface.faces)
            for (std::size_t i = 1; i + 1 < face.size(); ++i, ++sum.triangles) {
                const auto corner = [&](std::size_t k) -> Eigen::Vector3d {
                    return to_model(file, surface.vertices[static_cast<std::size_t>(face[k])]) - o;
                };
                const Eigen::Vector3d a = corner(0), b = corner(i), c = corner(i + 1);
                sum.volume += a.dot(b.cross(c)) / 6;
                sum.area += (b - a).cross(c - a).norm() / 2;
            }
    return sum;
}

std::string to_text(const Summary& sum)
{
    return sum.outcome + " " + std::to_string(sum.stones) + " " + std::to_string(sum.triangles) + " " +
           digits(sum.volume) + " " + digits(sum.area) + " " + digits(sum.rounding) + " " + digits(sum.lower) +
           " " + digits(sum.upper) + "\n" + sum.names;
}

Summary from_text(const std::string& text)
{
    Summary sum;
    std::istringstream stream(text);
    if (!(stream >> sum.outcome)) sum.outcome = "crash";
    stream >> sum.stones >> sum.triangles >> sum.volume >> sum.area >> sum.rounding;
    for (Eigen::Vector3d* corner : {&sum.lower, &sum.upper})
        for (int i = 0; i < 3; ++i) stream >> (*corner)[i];
    if (sum.outcome == "read") sum.names = text.substr(text.find('\n') + 1);
    return sum;
}

/// Reads in a child process. @param from corner of the cones; null: the lowest corner
Summary read_apart(const fs::path& file, mesh::MeshReader reader, const Eigen::Vector3d* from)
{
    int ends[2];
    if (pipe(ends) != 0) return {};
    const pid_t child = fork();
    if (child == 0) {
        const rlimit none{0, 0}, seconds{30, 30};
        setrlimit(RLIMIT_CORE, &none);
        setrlimit(RLIMIT_CPU, &seconds);
        if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(1);  // what a crash prints
        std::string text = "refused\n";
        try {
            text = to_text(summary_of(mesh::read_mesh(file, {mesh::StonesBy::detect, reader}), from));
        } catch (const InputError&) {
        }
        const bool written = write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size());
        _exit(written ? 0 : 1);
    }
    close(ends[1]);
    std::string text(1 << 16, '\0');
    std::size_t size = 0;
    for (ssize_t got = 1; got > 0 && size < text.size();
         size += static_cast<std::size_t>(std::max<ssize_t>(got, 0)))
        got = read(ends[0], text.data() + size, text.size() - size);
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? from_text(text.substr(0, size)) : Summary();
}

/// What two summaries disagree about. The tolerance is the rounding that assimp's reading states.
std::set<std::string> disagreements(const Summary& own, const Summary& assimp)
{
    if (assimp.outcome != "read") return {assimp.outcome};
    std::set<std::string> about;
    const double places = assimp.rounding + 1e-12 * own.upper.cwiseAbs().maxCoeff();
    if (own.stones != assimp.stones) about.insert("stones");
    if (own.triangles != assimp.triangles) about.insert("triangles");
    if (std::abs(own.volume - assimp.volume) > 10 * places * own.area) about.insert("volume");
    if ((own.lower - assimp.lower).cwiseAbs().maxCoeff() > places ||
        (own.upper - assimp.upper).cwiseAbs().maxCoeff() > places)
        about.insert("place");
    if (own.names != assimp.names) about.insert("names");
    return about;
}

struct Known {
    std::set<std::string> about;
    const char* why;
};
const std::map<std::string, Known> known{
    {"crossvault.obj",
     {{"stones", "names"}, "names are cut at the space: `Mesh 0` to `Mesh 183` become one mesh"}},
    {"ursula.obj", {{"stones", "names"}, "likewise, six stones"}},
    {"groups.obj",
     {{"names", "triangles", "volume"},
      "names are cut at the space, a group takes the place of the object, faces continued by a backslash are "
      "lost"}},
    {"concave_polygon.obj", {{"names"}, "a group takes the place of the object it is in"}},
    {"space_in_material_name.obj", {{"names"}, "likewise"}},
    {"ascii.stl", {{"names"}, "the name is cut at the space"}},
    {"ascii.ply", {{"triangles"}, "triangle strips are left out"}},
    {"binary_big_endian.ply", {{"triangles", "volume"}, "likewise, and the faces before them are taken wrongly"}},
    {"binary_little_endian.ply", {{"triangles", "volume"}, "likewise"}},
    {"prim.off", {{"triangles"}, "the blank line and the comment before the faces are counted as two of them"}},
    {"two.dae",
     {{"names", "place", "volume"}, "accessors without <param>: x is taken for y and z; names of nodes"}},
    {"box.3mf", {{"names", "place", "volume"}, "the unit (a millimetre) is lost, objects are numbered"}},
    {"plate.3mf", {{"refused"}, "components and build transforms are not read: nothing is left"}},
    {"cube_and_sphere_same_name.3mf", {{"crash"}, "assimp corrupts its heap and aborts"}},
    {"site.dxf",
     {{"names", "place", "stones", "triangles", "volume"},
      "MESH entities, the unit and names with spaces are lost; faces are taken wrongly"}},
};

std::vector<fs::path> files_below(const std::vector<fs::path>& folders)
{
    std::vector<fs::path> files;
    for (const fs::path& folder : folders) {
        if (!fs::exists(folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string words_of(const std::set<std::string>& about)
{
    std::string text;
    for (const std::string& word : about) text += (text.empty() ? "" : ", ") + word;
    return text.empty() ? "nothing" : text;
}

/// @returns how many files both have read
int compare_all(const std::vector<fs::path>& folders)
{
    int compared = 0;
    for (const fs::path& file : files_below(folders)) {
        const Summary own = read_apart(file, mesh::MeshReader::own, nullptr);
        EXPECT_NE(own.outcome, "crash") << file;
        if (own.outcome != "read" || file.extension() == ".json") continue;
        const Summary assimp = read_apart(file, mesh::MeshReader::assimp, &own.lower);
        const std::string name = file.filename();
        const auto entry = known.find(name);
        const std::set<std::string> expected =
            entry == known.end() ? std::set<std::string>() : entry->second.about;
        EXPECT_EQ(words_of(disagreements(own, assimp)), words_of(expected))
            << name << ": " << to_text(own) << to_text(assimp);
        compared += assimp.outcome == "read";
    }
    return compared;
}

/// A cube of 1 m at the coordinates of a survey, to a tenth of a millimetre.
mesh::PolygonSurface surveyed_cube()
{
    mesh::PolygonSurface cube = triangulated(unit_cube());
    cube.name = "stone";
    for (Eigen::Vector3d& x : cube.vertices) x += Eigen::Vector3d(500000.1234, 4600000.5678, 241.2);
    return cube;
}

}  // namespace

// The numbers of importers/mesh/README.md. Our readers keep all digits of these files.
TEST(TwoReaders, AssimpLosesAQuarterOfAMetreAtANorthingOf4600Km)
{
    const TemporaryFolder folder;
    const mesh::PolygonSurface cube = surveyed_cube();
    for (const fs::path& file :
         {folder.write("a.obj", mesh::to_obj({cube}, {})), folder.write("a.off", to_off(cube)),
          folder.write("a.stl", to_ascii_stl(cube, "stone")), folder.write("a.ply", to_ply(cube, "ascii")),
          folder.write("b.ply", to_ply(cube, "binary_little_endian"))}) {
        const mesh::MeshFile own = mesh::read_mesh(file),
                             other = mesh::read_mesh(file, {mesh::StonesBy::detect, mesh::MeshReader::assimp});
        const Eigen::Vector3d known = lowest_of(cube);
        EXPECT_EQ(lowest_of(own.surfaces.at(0)), known) << file;
        EXPECT_EQ(own.rounding, 0) << file;
        const double lost = (lowest_of(other.surfaces.at(0)) - known).cwiseAbs().maxCoeff();
        EXPECT_NEAR(lost, 0.0678, 1e-6) << file << ": of the multiples of 0.5 m that there are";
        EXPECT_NEAR(other.rounding, 4600001.5678 * 1.2e-7, 1e-3) << file;
    }
}

TEST(TwoReaders, AgreeOnTheFilesOfThisRepository)
{
    EXPECT_GE(compare_all({VOUSSOIR_MESH_SEEDS, VOUSSOIR_CASE_MESHES, VOUSSOIR_GEOMETRY_FIGURES}), 17);
}

TEST(TwoReaders, AgreeOnTheCollection)
{
    const char* variable = std::getenv("VOUSSOIR_DATA");
    const fs::path data = variable != nullptr ? variable : VOUSSOIR_DEFAULT_DATA;
    if (!fs::exists(data / "meshes")) GTEST_SKIP() << "no data: set VOUSSOIR_DATA";
    EXPECT_GE(compare_all({data / "meshes"}), 89);
}

}  // namespace voussoir::importers
