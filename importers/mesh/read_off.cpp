#include <algorithm>

#include "importers/mesh/formats.h"
#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

/// Lines of words without comments and empty lines.
class OffLines
{
 public:
    explicit OffLines(std::string_view text) : lines_(text) {}
    bool next()
    {
        for (std::string_view line; lines_.next(line);) {
            word = text::words(line.substr(0, line.find('#')));
            if (!word.empty()) return true;
        }
        word.clear();
        return false;
    }
    int number() const { return lines_.number(); }
    std::vector<std::string_view> word;

 private:
    Lines lines_;
};

/// Takes "OFF", "COFF", "STCNOFF" and the like off the first word. Coordinates come first in all of them, so that
/// colours, normals and textures may be passed over.
void read_keyword(OffLines& lines, const std::string& place)
{
    if (!lines.next()) throw InputError(place, "the file holds nothing but comments", "an OFF file has vertices");
    std::string_view& first = lines.word[0];
    const std::size_t end = first.find("OFF");
    if (end == std::string_view::npos) return;  // the keyword may be missing
    const std::string_view prefix = first.substr(0, end);
    if (prefix.find_first_of("4n") != std::string_view::npos)
        throw InputError(place + ":" + std::to_string(lines.number()), "its vertices are not in three dimensions",
                         "write the file as plain OFF");
    first.remove_prefix(end + 3);
    if (first.empty()) lines.word.erase(lines.word.begin());
    if (!lines.word.empty() && lines.word[0] == "BINARY")
        throw InputError(place, "this is a binary OFF file", "write it as text");
    if (lines.word.empty()) lines.next();
}

class OffReader
{
 public:
    explicit OffReader(const MeshSource& source)
        : source_(source), lines_(source.bytes), faults_(source.place), result_(source)
    {
    }

    MeshFile read()
    {
        read_keyword(lines_, source_.place);
        read_counts();
        for (std::size_t v = 0; v < vertices_ && next("vertices", v, vertices_); ++v) read_vertex();
        faults_.throw_if_any();
        for (std::size_t f = 0; f < faces_ && next("faces", f, faces_); ++f) read_face();
        faults_.throw_if_any();
        if (lines_.next()) result_.note("lines after the last face were left out");
        result_.add(std::move(surface_));
        return result_.finish();
    }

 private:
    void read_counts()
    {
        const std::vector<std::string_view>& word = lines_.word;
        const long long vertices = word.size() > 1 ? text::parse_integer(word[0]).value_or(-1) : -1;
        const long long faces = word.size() > 1 ? text::parse_integer(word[1]).value_or(-1) : -1;
        if (vertices < 0 || faces < 0)
            faults_.add(lines_.number(), "the counts of vertices and faces are missing",
                        "the first line after OFF reads `vertices faces edges`");
        faults_.throw_if_any();
        // "0 0 0\n" is the least a vertex can take, "0\n" the least a face can.
        const auto most = static_cast<long long>(source_.bytes.size());
        if (vertices > most / 5 || faces > most / 2)
            faults_.add(lines_.number(),
                        "the header announces " + std::to_string(vertices) + " vertices and " +
                            std::to_string(faces) + " faces",
                        "a file of " + std::to_string(most) + " bytes cannot hold them");
        faults_.throw_if_any();
        vertices_ = static_cast<std::size_t>(vertices);
        faces_ = static_cast<std::size_t>(faces);
    }

    /// The next line, or the fault that the file ends too early.
    bool next(const char* what, std::size_t read, std::size_t announced)
    {
        if (faults_.full()) return false;
        if (lines_.next()) return true;
        faults_.add(lines_.number(), "the file ends after " + std::to_string(read) + " " + what,
                    "the header announces " + std::to_string(announced));
        return false;
    }

    void read_vertex()
    {
        Eigen::Vector3d x = Eigen::Vector3d::Zero();
        if (!parse_point(lines_.word, 0, x))
            faults_.add(lines_.number(), "this vertex is not three finite numbers", "write `x y z`");
        surface_.vertices.push_back(x);
    }

    /// Colours may follow the corners.
    void read_face()
    {
        const std::vector<std::string_view>& word = lines_.word;
        const long long corners = text::parse_integer(word[0]).value_or(-1);
        if (corners < 3 || corners >= static_cast<long long>(word.size()))
            return faults_.add(lines_.number(), "this face does not have the three or more corners it counts",
                               "write `3 a b c`, the number of corners and the corners");
        std::vector<int> loop;
        for (std::size_t i = 1; i <= static_cast<std::size_t>(corners); ++i) {
            const long long v = text::parse_integer(word[i]).value_or(-1);
            if (v < 0 || v >= static_cast<long long>(surface_.vertices.size()))
                return faults_.add(
                    lines_.number(), "a face names vertex \"" + std::string(word[i]) + "\"",
                    "the file has " + std::to_string(surface_.vertices.size()) + " vertices, counted from 0");
            loop.push_back(static_cast<int>(v));
        }
        surface_.faces.push_back(std::move(loop));
    }

    const MeshSource& source_;
    OffLines lines_;
    FaultList faults_;
    SurfaceList result_;
    PolygonSurface surface_;
    std::size_t vertices_ = 0, faces_ = 0;
};

}  // namespace

MeshFile read_off(const MeshSource& source)
{
    return OffReader(source).read();
}

}  // namespace voussoir::importers::mesh
