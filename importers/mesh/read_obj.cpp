#include <algorithm>
#include <set>

#include "importers/mesh/formats.h"
#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

struct ObjFace {
    int object = 0, group = 0;           // index into the names of ObjScanner
    std::size_t first = 0, corners = 0;  // in the list of all corners
};

/// Reads line by line; one member function per kind of line.
class ObjScanner
{
 public:
    explicit ObjScanner(const MeshSource& source) : source_(source), faults_(source.place) {}

    void scan()
    {
        Lines lines(source_.bytes);
        std::string joined;
        int first_line = 0;
        for (std::string_view line; !faults_.full() && lines.next(line);) {
            if (joined.empty()) first_line = lines.number();
            line = text::trim(line);
            const bool goes_on = line.ends_with('\\');
            if (goes_on) line.remove_suffix(1);
            if (goes_on || !joined.empty()) joined.append(line).append(" ");
            if (goes_on) continue;
            read(joined.empty() ? line : text::trim(joined), first_line);
            joined.clear();
        }
        read(text::trim(joined), first_line);
        for (const auto& [index, line] : ahead_)
            if (index >= static_cast<long long>(vertices_.size()))
                faults_.add(line, "a face names vertex " + std::to_string(index + 1),
                            "the file has " + std::to_string(vertices_.size()) + " vertices");
        faults_.throw_if_any();
    }

    MeshFile finish(StonesBy stones)
    {
        const bool by_group =
            stones == StonesBy::group ||
            (stones == StonesBy::detect && used(&ObjFace::object) < 2 && used(&ObjFace::group) > 1);
        if (left_out_ > 0)
            result_.note(std::to_string(left_out_) + " lines, points, curves or free-form surfaces were left out");
        build(by_group ? groups_ : objects_, by_group ? &ObjFace::group : &ObjFace::object);
        return result_.finish();
    }

 private:
    void read(std::string_view text, int line)
    {
        const std::vector<std::string_view> word =
            text::words(text.substr(0, name_line(text) ? text.npos : text.find('#')));
        if (word.empty()) return;
        if (word[0] == "v") return read_vertex(word, line);
        if (word[0] == "f" || word[0] == "fo") return read_face(word, line);
        if (word[0] == "o") begin_object(text::trim(text.substr(1)));
        if (word[0] == "g") begin_group(text::trim(text.substr(1)));
        for (const char* kind : {"l", "p", "curv", "curv2", "surf"}) left_out_ += word[0] == kind;
    }

    /// Names may hold a "#", other lines end there.
    static bool name_line(std::string_view text)
    {
        return text.starts_with("o ") || text.starts_with("g ") || text.starts_with("o\t") ||
               text.starts_with("g\t");
    }

    void read_vertex(const std::vector<std::string_view>& word, int line)
    {
        Eigen::Vector3d x = Eigen::Vector3d::Zero();
        if (!parse_point(word, 1, x))
            faults_.add(line, "this vertex is not three finite numbers", "write `v x y z`");
        vertices_.push_back(x);
    }

    /// Only the vertex numbers count: "7/1/3" is 7.
    void read_face(const std::vector<std::string_view>& word, int line)
    {
        if (word.size() < 4) return faults_.add(line, "a face of fewer than three corners", "write `f a b c ...`");
        const auto count = static_cast<long long>(vertices_.size());
        faces_.push_back({object_, group_, corners_.size(), word.size() - 1});
        for (std::size_t i = 1; i < word.size(); ++i) {
            const std::string_view number = word[i].substr(0, word[i].find('/'));
            const long long index = text::parse_integer(number).value_or(0);
            if (index == 0 || index < -count)
                return faults_.add(line, "a face names vertex \"" + std::string(number) + "\"",
                                   "vertices are counted from 1, or backwards from -1");
            const long long vertex = index > 0 ? index - 1 : count + index;
            if (vertex >= count) ahead_.emplace_back(vertex, line);
            corners_.push_back(static_cast<std::size_t>(vertex));
        }
    }

    /// An equal group name goes on with the same stone, as the format has it; an equal object name is another
    /// stone.
    void begin_object(std::string_view name)
    {
        object_ = static_cast<int>(objects_.size());
        objects_.emplace_back(name.empty() ? "object" : name);
    }

    void begin_group(std::string_view name)
    {
        const std::string wanted(name.empty() ? "group" : name);
        const auto [known, is_new] = group_of_.emplace(wanted, static_cast<int>(groups_.size()));
        if (is_new) groups_.push_back(wanted);
        group_ = known->second;
    }

    std::size_t used(int ObjFace::*level) const
    {
        std::set<int> stones;
        for (const ObjFace& face : faces_) stones.insert(face.*level);
        return stones.size();
    }

    void build(const std::vector<std::string>& names, int ObjFace::*level)
    {
        std::vector<std::vector<std::size_t>> faces_of(names.size());
        for (std::size_t f = 0; f < faces_.size(); ++f) faces_of[faces_[f].*level].push_back(f);
        std::vector<int> local(vertices_.size(), -1);
        for (std::size_t stone = 0; stone < names.size(); ++stone) {
            if (stone == 0 && faces_of[0].empty()) continue;  // stone 0 is ours: faces before the first name
            PolygonSurface surface{names[stone], {}, {}};
            std::vector<std::size_t> taken;
            for (const std::size_t f : faces_of[stone]) {
                std::vector<int>& loop = surface.faces.emplace_back();
                for (std::size_t c = 0; c < faces_[f].corners; ++c) {
                    const std::size_t v = corners_[faces_[f].first + c];
                    if (local[v] < 0) {
                        local[v] = static_cast<int>(taken.size());
                        taken.push_back(v);
                        surface.vertices.push_back(vertices_[v]);
                    }
                    loop.push_back(local[v]);
                }
            }
            for (const std::size_t v : taken) local[v] = -1;
            result_.add(std::move(surface));
        }
    }

    const MeshSource& source_;
    FaultList faults_;
    SurfaceList result_{source_};
    std::vector<Eigen::Vector3d> vertices_;
    std::vector<std::size_t> corners_;
    std::vector<ObjFace> faces_;
    std::vector<std::string> objects_{""}, groups_{""};
    std::map<std::string, int> group_of_;
    int object_ = 0, group_ = 0;
    std::size_t left_out_ = 0;
    std::vector<std::pair<long long, int>> ahead_;  // vertices beyond those read so far, with their lines
};

}  // namespace

MeshFile read_obj(const MeshSource& source, const ReadOptions& options)
{
    ObjScanner scanner(source);
    scanner.scan();
    return scanner.finish(options.stones);
}

}  // namespace voussoir::importers::mesh
