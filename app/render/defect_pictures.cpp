#include "app/render/defect_pictures.h"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "app/words/lines.h"
#include "importers/process/child_process.h"
#include "libdda/errors.h"

namespace voussoir::app::render
{

namespace
{

namespace fs = std::filesystem;
using Eigen::Vector3d;
using nlohmann::json;

constexpr double seconds_allowed = 300;
constexpr std::size_t max_output = std::size_t{1} << 20;  // bytes, a list of paths

json to_json_value(const std::vector<Vector3d>& points)
{
    json value = json::array();
    for (const Vector3d& x : points) value.push_back({x.x(), x.y(), x.z()});
    return value;
}

std::vector<Vector3d> points_from(const json& value)
{
    std::vector<Vector3d> points;
    for (const json& x : value)
        points.emplace_back(x.at(0).get<double>(), x.at(1).get<double>(), x.at(2).get<double>());
    return points;
}

json to_json_value(const PictureMark& mark)
{
    json lines = json::array(), polygons = json::array();
    for (const auto& line : mark.feature.lines) lines.push_back(to_json_value({line[0], line[1]}));
    for (const auto& polygon : mark.feature.polygons) polygons.push_back(to_json_value(polygon));
    return {{"label", mark.feature.label},
            {"look", static_cast<int>(mark.look)},
            {"points", to_json_value(mark.feature.points)},
            {"lines", std::move(lines)},
            {"polygons", std::move(polygons)}};
}

template <typename Look>
Look look_from(const json& value, int count)
{
    const int number = value.get<int>();
    if (number < 0 || number >= count) throw std::out_of_range("an unknown style");
    return static_cast<Look>(number);
}

PictureMark mark_from(const json& value)
{
    PictureMark mark;
    mark.feature.label = value.at("label");
    mark.look = look_from<MarkLook>(value.at("look"), mark_looks);
    mark.feature.points = points_from(value.at("points"));
    for (const json& line : value.at("lines")) {
        const std::vector<Vector3d> ends = points_from(line);
        mark.feature.lines.push_back({ends.at(0), ends.at(1)});
    }
    for (const json& polygon : value.at("polygons")) mark.feature.polygons.push_back(points_from(polygon));
    return mark;
}

json to_json_value(const DefectPicture& picture)
{
    json stones = json::array(), marks = json::array(), legend = json::array(), mark_legend = json::array();
    for (const PictureStone& stone : picture.stones) stones.push_back({stone.shape, static_cast<int>(stone.look)});
    for (const PictureMark& mark : picture.marks) marks.push_back(to_json_value(mark));
    for (const auto& [look, words] : picture.legend) legend.push_back({static_cast<int>(look), words});
    for (const auto& [look, words] : picture.mark_legend) mark_legend.push_back({static_cast<int>(look), words});
    return {{"name", picture.name},   {"title", picture.title},     {"subtitle", picture.subtitle},
            {"stones", stones},       {"marks", std::move(marks)},  {"legend", legend},
            {"notes", picture.notes}, {"mark_legend", mark_legend}, {"frame_ghosts", picture.frame_ghosts}};
}

DefectPicture picture_from(const json& value)
{
    DefectPicture picture;
    picture.name = value.at("name");
    picture.title = value.at("title");
    picture.subtitle = value.at("subtitle");
    picture.frame_ghosts = value.at("frame_ghosts");
    picture.notes = value.at("notes").get<std::vector<std::string>>();
    for (const json& stone : value.at("stones"))
        picture.stones.push_back({stone.at(0), look_from<StoneLook>(stone.at(1), stone_looks)});
    for (const json& mark : value.at("marks")) picture.marks.push_back(mark_from(mark));
    for (const json& entry : value.at("legend"))
        picture.legend.emplace_back(look_from<StoneLook>(entry.at(0), stone_looks), entry.at(1));
    for (const json& entry : value.at("mark_legend"))
        picture.mark_legend.emplace_back(look_from<MarkLook>(entry.at(0), mark_looks), entry.at(1));
    return picture;
}

}  // namespace

std::string to_json(const DefectPictures& pictures, const fs::path& folder)
{
    json shapes = json::array(), drawn = json::array();
    for (const PictureShape& shape : pictures.shapes)
        shapes.push_back({{"vertices", to_json_value(shape.vertices)}, {"faces", shape.faces}});
    for (const DefectPicture& picture : pictures.pictures) drawn.push_back(to_json_value(picture));
    return json{{"folder", folder.string()},
                {"size", {pictures.width, pictures.height}},
                {"shapes", std::move(shapes)},
                {"pictures", std::move(drawn)}}
        .dump(-1, ' ', false, json::error_handler_t::replace);
}

DefectRequest defects_from_json(const std::string& text)
{
    const json value = json::parse(text);
    DefectRequest request;
    request.folder = value.at("folder").get<std::string>();
    request.pictures.width = value.at("size").at(0);
    request.pictures.height = value.at("size").at(1);
    for (const json& shape : value.at("shapes")) {
        request.pictures.shapes.push_back(
            {points_from(shape.at("vertices")), shape.at("faces").get<std::vector<std::vector<int>>>()});
        const PictureShape& made = request.pictures.shapes.back();
        for (const std::vector<int>& face : made.faces)
            for (const int v : face) made.vertices.at(v);
    }
    for (const json& picture : value.at("pictures")) {
        request.pictures.pictures.push_back(picture_from(picture));
        for (const PictureStone& stone : request.pictures.pictures.back().stones)
            request.pictures.shapes.at(stone.shape);
    }
    return request;
}

bool can_draw_defects()
{
    std::error_code none;
    return fs::exists(importers::process::helper_folder() / "voussoir-defects", none);
}

std::vector<fs::path> draw_defects(const DefectPictures& pictures, const fs::path& folder)
{
    const fs::path helper = importers::process::helper_folder() / "voussoir-defects";
    if (!can_draw_defects())
        throw InputError(helper.string(), "there is no such program",
                         "build voussoir with VOUSSOIR_RENDER=ON to have pictures");
    const importers::process::ChildAnswer answer =
        importers::process::ask_child(helper, to_json(pictures, folder), seconds_allowed, max_output);
    if (!answer.failure.empty())
        throw InputError(folder.string(), "voussoir-defects drew no pictures: " + answer.failure,
                         "see its message");
    const std::vector<std::string> files = words::lines_of(answer.output);
    return {files.begin(), files.end()};
}

}  // namespace voussoir::app::render
