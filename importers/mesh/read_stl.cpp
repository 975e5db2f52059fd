#include <cstdint>

#include "importers/mesh/formats.h"
#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

constexpr std::size_t header_size = 80, facet_size = 50;

/// Word by word: line ends mean nothing but for the names of solids.
class AsciiStl
{
 public:
    explicit AsciiStl(const MeshSource& source) : source_(source), faults_(source.place), result_(source) {}

    MeshFile read()
    {
        Lines lines(source_.bytes);
        for (std::string_view line; !faults_.full() && lines.next(line);)
            read_line(text::trim(line), lines.number());
        if (faults_.full()) faults_.throw_if_any();
        if (numbers_left_ > 0 || !loop_.empty() || in_solid_)
            faults_.add(lines.number(), "the file ends within a solid",
                        "it must end with `endsolid`: the file was cut off");
        faults_.throw_if_any();
        return result_.finish();
    }

 private:
    void read_line(std::string_view line, int number)
    {
        for (const std::string_view word : text::words(line)) {
            const std::string keyword = text::lower_case(word);
            if (numbers_left_ > 0) {
                read_number(word, number);
            } else if (keyword == "solid" || keyword == "endsolid") {  // what follows is the name
                const std::size_t end = static_cast<std::size_t>(word.data() - line.data()) + word.size();
                return keyword == "solid" ? begin_solid(text::trim(line.substr(end))) : end_solid();
            } else if (!read_keyword(keyword, number)) {
                return faults_.add(number,
                                   "\"" + std::string(word.substr(0, 40)) + "\" is not a keyword of STL files",
                                   "lines are `facet`, `outer loop`, `vertex x y z`, `endloop`, `endfacet`");
            }
        }
    }

    bool read_keyword(const std::string& keyword, int line)
    {
        if (keyword == "vertex" || keyword == "normal") {
            numbers_left_ = 3;
            is_normal_ = keyword == "normal";
            if (!is_normal_) loop_.emplace_back();
        } else if (keyword == "endloop") {
            if (loop_.size() != 3)
                faults_.add(line, "this facet has " + std::to_string(loop_.size()) + " corners",
                            "a facet is a triangle");
            solid_.faces.emplace_back();
            for (const Eigen::Vector3d& x : loop_) {
                solid_.faces.back().push_back(static_cast<int>(solid_.vertices.size()));
                solid_.vertices.push_back(x);
            }
            loop_.clear();
        } else if (keyword != "facet" && keyword != "outer" && keyword != "loop" && keyword != "endfacet") {
            return false;
        }
        return true;
    }

    /// Normals are passed over, whatever they say: the order of the corners counts.
    void read_number(std::string_view word, int line)
    {
        const std::optional<double> value = text::parse_finite(word);
        if (!is_normal_ && !value)
            faults_.add(line, "\"" + std::string(word.substr(0, 40)) + "\" is not a finite number",
                        "write `vertex x y z`");
        if (!is_normal_) loop_.back()[3 - numbers_left_] = value.value_or(0);
        --numbers_left_;
    }

    void begin_solid(std::string_view name)
    {
        if (in_solid_ || !solid_.faces.empty()) end_solid();
        solid_.name = name;
        in_solid_ = true;
    }

    void end_solid()
    {
        if (in_solid_) result_.add(std::move(solid_));
        solid_ = {};
        in_solid_ = false;
    }

    const MeshSource& source_;
    FaultList faults_;
    SurfaceList result_;
    PolygonSurface solid_;
    std::vector<Eigen::Vector3d> loop_;
    int numbers_left_ = 0;
    bool is_normal_ = false, in_solid_ = false;
};

MeshFile read_binary(const MeshSource& source)
{
    const std::string& bytes = source.bytes;
    if (bytes.size() < header_size + 4)
        throw InputError(source.place, "the file is " + std::to_string(bytes.size()) + " bytes long",
                         "a binary STL file begins with 84 bytes of header");
    const std::size_t facets = load<std::uint32_t>(&bytes[header_size]);
    const std::size_t announced = header_size + 4 + facet_size * facets;
    if (announced > bytes.size())
        throw InputError(source.place,
                         "the header announces " + std::to_string(facets) + " facets, which need " +
                             std::to_string(announced) + " bytes, but the file has " +
                             std::to_string(bytes.size()),
                         "the file was cut off, or it is not a STL file");
    SurfaceList result(source);
    if (announced < bytes.size())
        result.note(std::to_string(bytes.size() - announced) + " bytes after the last facet were left out");
    PolygonSurface surface;
    for (std::size_t f = 0; f < facets; ++f) {
        const char* corner = &bytes[header_size + 4 + facet_size * f + 12];
        const int first = static_cast<int>(surface.vertices.size());
        for (int c = 0; c < 3; ++c, corner += 12)
            surface.vertices.emplace_back(load<float>(corner), load<float>(corner + 4), load<float>(corner + 8));
        surface.faces.push_back({first, first + 1, first + 2});
    }
    result.add(std::move(surface));
    return result.finish();
}

}  // namespace

bool is_binary_stl(std::string_view bytes)
{
    if (bytes.size() < header_size + 4) return false;
    return bytes.size() == header_size + 4 + facet_size * std::size_t{load<std::uint32_t>(&bytes[header_size])};
}

MeshFile read_stl(const MeshSource& source)
{
    // Many binary files begin with "solid" too: the length decides, then zero bytes, which no text has.
    const bool text =
        text::lower_case(text::trim(std::string_view(source.bytes).substr(0, 200))).starts_with("solid") &&
        !is_binary_stl(source.bytes) && source.bytes.find('\0') == std::string::npos;
    return text ? AsciiStl(source).read() : read_binary(source);
}

}  // namespace voussoir::importers::mesh
