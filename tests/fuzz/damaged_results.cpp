#include "tests/fuzz/damaged_results.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "app/results/results_reader.h"
#include "libdda/errors.h"

namespace voussoir
{

namespace
{

using Values = std::vector<double>;

void put(DraftResults& draft, const std::string& name, app::results::ElementType type,
         app::results::Extents extents, Values values)
{
    draft.numbers[name] = {type, std::move(extents), std::move(values)};
}

/// The outlines of a box as corners of its faces, all about the centroid.
void put_mesh(DraftResults& draft, bool planar)
{
    Values levers, corners, faces;
    for (int block = 0; block < 2; ++block)
        for (int corner = 0; corner < (planar ? 4 : 8); ++corner)
            for (int axis = 0; axis < (planar ? 2 : 3); ++axis)
                levers.push_back((corner >> axis & 1) != 0 ? 0.5 : -0.5);
    const std::vector<Values> loops =
        planar ? std::vector<Values>{{0, 1, 3, 2}} : std::vector<Values>{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    const double vertices = planar ? 4 : 8;
    Values first{0}, part;
    for (int block = 0; block < 2; ++block)
        for (const Values& loop : loops) {
            for (const double corner : loop) corners.push_back(corner + block * vertices);
            first.push_back(static_cast<double>(corners.size()));
            faces.push_back(block);
            part.push_back(0);
        }
    const auto count = [](const Values& values) { return app::results::Extents{values.size()}; };
    put(draft, "/model/mesh/levers", app::results::ElementType::float64, count(levers), levers);
    put(draft, "/model/mesh/block_first_vertex", app::results::ElementType::int32, {3},
        {0, vertices, 2 * vertices});
    put(draft, "/model/mesh/face_first", app::results::ElementType::int32, count(first), first);
    put(draft, "/model/mesh/face_vertices", app::results::ElementType::int32, count(corners), corners);
    put(draft, "/model/mesh/face_block", app::results::ElementType::int32, count(faces), faces);
    put(draft, "/model/mesh/face_part", app::results::ElementType::int32, count(part), part);
}

void put_frames(DraftResults& draft, bool planar)
{
    const std::uint64_t d = planar ? 2 : 3, coordinates = planar ? 3 : 12, unknowns = planar ? 3 : 12;
    const auto zeros = [](std::uint64_t count) { return Values(count, 0.25); };
    Values places(2 * 2 * coordinates, 0.0);
    for (std::size_t i = 0; i < places.size(); i += coordinates)
        for (const std::size_t one : {3U, 7U, 11U})
            if (one < coordinates) places[i + one] = 1;
    put(draft, "/frames/count", app::results::ElementType::int64, {1}, {2});
    put(draft, "/frames/time", app::results::ElementType::float64, {2}, {0, 0.5});
    put(draft, "/frames/step", app::results::ElementType::int64, {2}, {0, 100});
    put(draft, "/frames/stage", app::results::ElementType::int32, {2}, {0, 1});
    put(draft, "/frames/coordinates", app::results::ElementType::float64, {2, 2, coordinates}, places);
    put(draft, "/frames/velocities", app::results::ElementType::float64, {2, 2, unknowns},
        zeros(2 * 2 * unknowns));
    put(draft, "/frames/ground_displacement", app::results::ElementType::float64, {2, d}, zeros(2 * d));
    if (!planar) put(draft, "/frames/stress", app::results::ElementType::float64, {2, 2, 6}, zeros(24));
    put(draft, "/frames/contacts/rows", app::results::ElementType::int64, {2, 2}, {0, 1, 1, 1});
    put(draft, "/frames/contacts/pair", app::results::ElementType::int32, {2, 2}, {0, 1, 0, 1});
    for (const char* name : {"force", "centre", "pressure_centre", "normal"})
        put(draft, std::string("/frames/contacts/") + name, app::results::ElementType::float64, {2, d},
            zeros(2 * d));
    put(draft, "/frames/contacts/moment", app::results::ElementType::float64,
        planar ? app::results::Extents{2} : app::results::Extents{2, 3}, zeros(planar ? 2 : 6));
    for (const char* name : {"normal_force", "area", "closed_area"})
        put(draft, std::string("/frames/contacts/") + name, app::results::ElementType::float64, {2}, zeros(2));
}

void put_joints(DraftResults& draft, bool planar)
{
    const std::uint64_t d = planar ? 2 : 3;
    put(draft, "/joints/pair", app::results::ElementType::int32, {1, 2}, {0, 1});
    for (const char* name : {"area", "facing_area"})
        put(draft, std::string("/joints/") + name, app::results::ElementType::float64, {1}, {0.25});
    for (const char* name : {"centre", "normal"})
        put(draft, std::string("/joints/") + name, app::results::ElementType::float64, {1, d}, Values(d, 0.25));
    for (const char* name : {"opening", "mean_opening", "slip", "largest_slip", "normal_force", "shear_force",
                             "eccentricity", "area_in_use"})
        put(draft, std::string("/frames/joints/") + name, app::results::ElementType::float32, {2, 1}, {0.25, 0.5});
}

void put_materials(DraftResults& draft)
{
    put(draft, "/model/block_group", app::results::ElementType::int32, {2}, {1, 1});
    put(draft, "/model/joint_of_groups", app::results::ElementType::int32, {2, 2}, {0, 0, 0, 0});
    for (const char* name : {"friction_angle", "cohesion"})
        put(draft, std::string("/model/joint_materials/") + name, app::results::ElementType::float64, {1}, {0.5});
    put(draft, "/model/friction_factor", app::results::ElementType::float64, {2}, {0.9, 1.1});
}

/// Takes bytes from the front; zeros when there are none left.
class Bytes
{
 public:
    explicit Bytes(std::string_view rest) : rest_(rest) {}
    bool empty() const { return rest_.empty(); }
    template <typename T>
    T take()
    {
        T value{};
        const std::size_t count = std::min(sizeof(T), rest_.size());
        std::memcpy(&value, rest_.data(), count);
        rest_.remove_prefix(count);
        return value;
    }
    std::string text(std::size_t length)
    {
        const std::string taken(rest_.substr(0, length));
        rest_.remove_prefix(taken.size());
        return taken;
    }

 private:
    std::string_view rest_;
};

template <typename Map>
auto any_of(Map& map, Bytes& bytes)
{
    return std::next(map.begin(), static_cast<std::ptrdiff_t>(bytes.take<std::uint8_t>() % map.size()));
}

double odd_value(Bytes& bytes)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    static const Values odd{-1, 0, 1, 2, 1e9, -1e300, infinity, std::nan(""), 2147483647, -2147483648.0, 9e18};
    const std::uint8_t choice = bytes.take<std::uint8_t>();
    return choice < odd.size() ? odd[choice] : bytes.take<std::int16_t>();
}

void reshape(DraftDataset& data, Bytes& bytes)
{
    const std::uint8_t axes = bytes.take<std::uint8_t>() % 4;
    std::uint64_t count = 1;
    data.extents.clear();
    for (std::uint8_t axis = 0; axis < axes; ++axis) data.extents.push_back(bytes.take<std::uint8_t>() % 30);
    for (const std::uint64_t size : data.extents) count *= size;
    data.values.resize(count, 1);
}

void edit_text(DraftResults& draft, Bytes& bytes)
{
    if (draft.texts.empty()) return;
    std::vector<std::string>& texts = any_of(draft.texts, bytes)->second;
    const std::uint8_t which = bytes.take<std::uint8_t>(), length = bytes.take<std::uint8_t>();
    if (which % 8 == 7) texts.resize(length % 5);
    if (!texts.empty()) texts[which % texts.size()] = bytes.text(length);
}

template <typename T>
void write_as(const std::string& name, const DraftDataset& data, app::results::Hdf5File& file)
{
    std::vector<T> values;
    for (const double value : data.values) {
        const bool is_whole = std::numeric_limits<T>::is_integer;
        const double lowest = static_cast<double>(std::numeric_limits<T>::lowest()),
                     highest = static_cast<double>(std::numeric_limits<T>::max());
        // 2^63 - 1 is no double: half of it is as good.
        if (is_whole && !(value >= lowest && value <= highest / 2)) {
            values.push_back(value < 0 ? std::numeric_limits<T>::lowest() : std::numeric_limits<T>::max());
        } else {
            values.push_back(static_cast<T>(is_whole ? value : std::clamp(value, lowest, highest)));
        }
    }
    file.write(name, values, data.extents);
}

}  // namespace

DraftResults two_boxes(bool planar)
{
    DraftResults draft;
    draft.attributes = {
        {"format", "voussoir results 2"},
        {"voussoir_version", "0"},
        {"title", "Two boxes"},
        {"kinematics", std::string(name_of(planar ? Kinematics::planar_rigid : Kinematics::spatial_deformable))}};
    draft.texts = {
        {"/model/block_names", {"lower", "upper"}},
        {"/model/groups", {"stones", "ground"}},
        {"/case/settings", {R"([{"name":"weight","type":"static"},{"name":"quake","type":"dynamic"}])"}}};
    put(draft, "/model/centroid", app::results::ElementType::float64, {2, planar ? 2U : 3U},
        Values(planar ? 4 : 6, 0.5));
    put(draft, "/model/foundations/block", app::results::ElementType::int32, {1}, {0});
    put_mesh(draft, planar);
    put_frames(draft, planar);
    put_joints(draft, planar);
    put_materials(draft);
    return draft;
}

void edit(std::string_view text, DraftResults& draft)
{
    for (Bytes bytes(text); !bytes.empty() && !draft.numbers.empty();) {
        const std::uint8_t what = bytes.take<std::uint8_t>();
        const auto at = any_of(draft.numbers, bytes);
        DraftDataset& data = at->second;
        switch (what % 7) {
            case 0:
                reshape(data, bytes);
                break;
            case 1:
                draft.numbers.erase(at);
                break;
            case 2:
                data.type = static_cast<app::results::ElementType>(bytes.take<std::uint8_t>() % 4);
                break;
            case 3:
                edit_text(draft, bytes);
                break;
            case 4:
                if (bytes.take<std::uint8_t>() % 4 == 0) draft.thickness = odd_value(bytes);
                any_of(draft.attributes, bytes)->second = bytes.text(bytes.take<std::uint8_t>() % 32);
                break;
            case 5:
                draft.stress_columns[bytes.take<std::uint8_t>() % draft.stress_columns.size()] =
                    bytes.text(bytes.take<std::uint8_t>() % 4);
                break;
            default:
                if (!data.values.empty())
                    data.values[bytes.take<std::uint16_t>() % data.values.size()] = odd_value(bytes);
        }
    }
}

void write_draft(const DraftResults& draft, const std::filesystem::path& path)
{
    app::results::Hdf5File file = app::results::Hdf5File::create(path);
    for (const char* group :
         {"/model", "/model/mesh", "/model/foundations", "/case", "/frames", "/frames/contacts"})
        file.make_group(group);
    for (const auto& [name, text] : draft.attributes) file.attribute("/", name, text);
    file.attribute("/", "thickness_m", draft.thickness);
    for (const auto& [name, texts] : draft.texts) file.write_texts(name, texts);
    for (const auto& [name, data] : draft.numbers) {
        const std::string group = name.substr(0, name.rfind('/'));
        if (!file.has(group)) file.make_group(group);
        if (data.type == app::results::ElementType::float32) write_as<float>(name, data, file);
        if (data.type == app::results::ElementType::float64) write_as<double>(name, data, file);
        if (data.type == app::results::ElementType::int32) write_as<std::int32_t>(name, data, file);
        if (data.type == app::results::ElementType::int64) write_as<std::int64_t>(name, data, file);
    }
    if (draft.numbers.count("/frames/stress") > 0)
        file.attribute("/frames/stress", "columns", draft.stress_columns);
    file.close();
}

void read_everything(const std::filesystem::path& path)
{
    const app::results::ResultsReader results(path);
    for (std::size_t frame = 0; frame < results.times.size(); ++frame) {
        const app::results::RecordedFrame recorded = results.frame(frame);
        app::results::positions_of(results.model.mesh, results.model.kinematics, recorded.state);
    }
}

}  // namespace voussoir
