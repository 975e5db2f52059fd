#include <algorithm>
#include <cmath>
#include <cstdint>

#include "importers/mesh/ply_header.h"
#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

double load_number(PlyType type, const char* at, bool big_endian)
{
    switch (type) {
        case PlyType::int8:
            return load<std::int8_t>(at, big_endian);
        case PlyType::uint8:
            return load<std::uint8_t>(at, big_endian);
        case PlyType::int16:
            return load<std::int16_t>(at, big_endian);
        case PlyType::uint16:
            return load<std::uint16_t>(at, big_endian);
        case PlyType::int32:
            return load<std::int32_t>(at, big_endian);
        case PlyType::uint32:
            return load<std::uint32_t>(at, big_endian);
        case PlyType::float32:
            return load<float>(at, big_endian);
        case PlyType::float64:
            return load<double>(at, big_endian);
        case PlyType::none:
            break;
    }
    return 0;
}

/// The numbers after the header one by one, text or binary.
class PlyNumbers
{
 public:
    PlyNumbers(const MeshSource& source, const PlyHeader& header)
        : source_(source),
          format_(header.format),
          rest_(std::string_view(source.bytes).substr(header.size)),
          line_(header.lines + 1)
    {
    }

    double next(PlyType type) { return format_ == PlyHeader::Format::ascii ? next_word() : next_bytes(type); }

    /// How many numbers of this type can still follow at most.
    std::size_t left(PlyType type) const
    {
        return format_ == PlyHeader::Format::ascii ? (rest_.size() + 1) / 2 : rest_.size() / size_of(type);
    }

    bool at_end() const { return format_ == PlyHeader::Format::ascii ? text::trim(rest_).empty() : rest_.empty(); }

    std::string place() const
    {
        return format_ == PlyHeader::Format::ascii ? source_.place + ":" + std::to_string(line_) : source_.place;
    }

    [[noreturn]] void cut_off() const
    {
        throw InputError(place(), "the file ends before the elements its header announces",
                         "the file was cut off");
    }

 private:
    double next_word()
    {
        const std::size_t start = std::min(rest_.find_first_not_of(" \t\r\n\v\f"), rest_.size());
        line_ += static_cast<int>(std::count(rest_.begin(), rest_.begin() + static_cast<long>(start), '\n'));
        rest_.remove_prefix(start);
        if (rest_.empty()) cut_off();
        const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r\n\v\f"));
        rest_.remove_prefix(word.size());
        const std::optional<double> value = text::parse_number(word);
        if (!value)
            throw InputError(place(), "\"" + std::string(word.substr(0, 40)) + "\" is not a number",
                             "elements are numbers");
        return *value;
    }

    double next_bytes(PlyType type)
    {
        if (rest_.size() < size_of(type)) cut_off();
        const double value = load_number(type, rest_.data(), format_ == PlyHeader::Format::big_endian);
        rest_.remove_prefix(size_of(type));
        return value;
    }

    const MeshSource& source_;
    PlyHeader::Format format_;
    std::string_view rest_;
    int line_;
};

class PlyReader
{
 public:
    explicit PlyReader(const MeshSource& source)
        : source_(source), header_(read_ply_header(source)), numbers_(source, header_), result_(source)
    {
    }

    MeshFile read()
    {
        bool has_faces = false;
        for (const PlyElement& element : header_.elements)
            has_faces = has_faces || element.name == "face" || element.name == "tristrips";
        if (!has_faces)
            throw InputError(source_.place, "the header has no element \"face\": this is a cloud of points",
                             "a mesh file has faces");
        for (const PlyElement& element : header_.elements)
            for (std::size_t i = 0; i < element.count; ++i) read_one(element);
        if (!numbers_.at_end()) result_.note("what follows the last element was left out");
        for (std::vector<int>& face : surface_.faces)
            for (const int v : face) checked_index(v, surface_.vertices.size(), source_.place);
        result_.add(std::move(surface_));
        return result_.finish();
    }

 private:
    void read_one(const PlyElement& element)
    {
        const bool vertex = element.name == "vertex";
        Eigen::Vector3d x = Eigen::Vector3d::Zero();
        for (const PlyProperty& property : element.properties) {
            const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
            if (property.count != PlyType::none) {
                read_list(property);
                if (element.name == "face" && corners) add_face();
                if (element.name == "tristrips" && corners) add_strips();
                continue;
            }
            const double value = numbers_.next(property.type);
            if (property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
                x[property.name[0] - 'x'] = value;
        }
        if (vertex && !x.allFinite())
            throw InputError(numbers_.place(),
                             "vertex " + std::to_string(surface_.vertices.size()) + " is not finite",
                             "coordinates are numbers");
        if (vertex) surface_.vertices.push_back(x);
    }

    void read_list(const PlyProperty& property)
    {
        const double count = numbers_.next(property.count);
        if (!(count >= 0) || count != std::floor(count))
            throw InputError(numbers_.place(), "a list counts " + std::to_string(count) + " entries",
                             "the count is a whole number");
        if (count > static_cast<double>(numbers_.left(property.type))) numbers_.cut_off();
        list_.resize(static_cast<std::size_t>(count));
        for (double& entry : list_) entry = numbers_.next(property.type);
    }

    int corner(double index) const
    {
        if (index >= 0 && index < 2147483648.0 && index == std::floor(index)) return static_cast<int>(index);
        throw InputError(numbers_.place(), "a face names vertex " + std::to_string(index),
                         "vertices are counted from 0");
    }

    void add_face()
    {
        std::vector<int>& face = surface_.faces.emplace_back();
        for (const double index : list_) face.push_back(corner(index));
    }

    /// Triangles that share an edge with the one before, every second one turned; -1 begins a new strip.
    void add_strips()
    {
        std::size_t first = 0;
        for (std::size_t i = 0; i < list_.size(); ++i) {
            if (list_[i] == -1) first = i + 1;
            if (i < first + 2 || list_[i] == -1) continue;
            const bool turned = (i - first) % 2 == 1;
            surface_.faces.push_back(
                {corner(list_[turned ? i - 1 : i - 2]), corner(list_[turned ? i - 2 : i - 1]), corner(list_[i])});
        }
    }

    const MeshSource& source_;
    PlyHeader header_;
    PlyNumbers numbers_;
    SurfaceList result_;
    PolygonSurface surface_;
    std::vector<double> list_;
};

}  // namespace

MeshFile read_ply(const MeshSource& source)
{
    return PlyReader(source).read();
}

}  // namespace voussoir::importers::mesh
