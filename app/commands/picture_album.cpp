#include "app/commands/picture_album.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace voussoir::app::commands
{
namespace
{

using Eigen::Vector3d;

constexpr std::size_t max_pictures = 20, max_neighbours = 60, least_context = 12;
constexpr double neighbourhood = 0.25;  // of the diagonal of what the picture is about

/// "defect_03_stone_7.png"; letters that file systems or shells dislike become underscores.
std::string file_name(std::size_t number, const std::string& name)
{
    std::string safe = name.substr(0, 60);
    for (char& c : safe)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
    return fmt::format("defect_{:02}_{}.png", number, safe);
}

/// Stones around those of the picture, as ghosts, the nearest first.
void add_neighbours(const Album& album, render::DefectPicture& picture)
{
    Eigen::AlignedBox3d box;
    std::set<int> shown;
    for (const render::PictureStone& stone : picture.stones) {
        box.extend(album.bounds[stone.shape]);
        shown.insert(stone.shape);
    }
    const double reach = neighbourhood * box.diagonal().norm();
    std::vector<std::pair<double, int>> near;
    for (int i = 0; i < static_cast<int>(album.bounds.size()); ++i)
        if (!shown.contains(i)) near.emplace_back(box.exteriorDistance(album.bounds[i]), i);
    std::sort(near.begin(), near.end());
    std::size_t count = 0;
    while (count < near.size() && count < max_neighbours && near[count].first < reach) ++count;
    if (picture.frame_ghosts) count = std::min(near.size(), std::max(count, least_context));
    near.resize(count);
    for (const auto& [distance, shape] : near) picture.stones.push_back({shape, render::StoneLook::ghost});
    if (!near.empty()) picture.legend.emplace_back(render::StoneLook::ghost, "neighbours");
}

}  // namespace

render::PictureShape shape_of(const std::vector<ConvexPolyhedron>& parts)
{
    render::PictureShape shape;
    for (const ConvexPolyhedron& part : parts) {
        const int first = static_cast<int>(shape.vertices.size());
        shape.vertices.insert(shape.vertices.end(), part.vertices.begin(), part.vertices.end());
        for (int face = 0; face < static_cast<int>(part.faces.size()); ++face) {
            if (part.is_glued(face)) continue;
            shape.faces.push_back(part.faces[face]);
            for (int& v : shape.faces.back()) v += first;
        }
    }
    return shape;
}

void add_shape(render::PictureShape shape, Album& album)
{
    Eigen::AlignedBox3d box;
    for (const Vector3d& x : shape.vertices) box.extend(x);
    album.bounds.push_back(box);
    album.pictures.shapes.push_back(std::move(shape));
}

void add_picture(render::DefectPicture picture, const std::string& name, Album& album)
{
    if (album.pictures.pictures.size() > max_pictures) {
        ++album.left_out;
        return;
    }
    add_neighbours(album, picture);
    picture.name = file_name(album.pictures.pictures.size(), name);
    album.pictures.pictures.push_back(std::move(picture));
}

std::vector<std::string> notes_about(const importers::assembly::Assembly& assembly, const std::string& kind,
                                     int stone)
{
    for (const importers::assembly::AssemblyFinding& finding : assembly.findings)
        if (finding.kind == kind &&
            std::find(finding.stones.begin(), finding.stones.end(), stone) != finding.stones.end())
            return {finding.what, "Remedy: " + finding.advice};
    return {};
}

render::DefectPicture pair_picture(const Album& album, int a, int b, const std::string& words)
{
    render::DefectPicture picture;
    const std::string &name_a = album.assembly.stones[a].name, &name_b = album.assembly.stones[b].name;
    picture.title = fmt::format("{} and {}: {}", name_a, name_b, words);
    picture.subtitle = album.title;
    picture.stones = {{a, render::StoneLook::first}, {b, render::StoneLook::second}};
    picture.legend = {{render::StoneLook::first, name_a}, {render::StoneLook::second, name_b}};
    return picture;
}

importers::mesh::MarkedFeature overlap_mark(const importers::assembly::Assembly& assembly,
                                            const importers::assembly::StoneOverlap& overlap)
{
    importers::mesh::MarkedFeature mark{fmt::format("shared: {:.3g} m3", overlap.volume), {}, {}, {}};
    if (overlap.depth > 0) mark.label += ", " + importers::assembly::length_words(overlap.depth) + " deep";
    for (const ConvexPolyhedron& a : assembly.stones[overlap.a].parts)
        for (const ConvexPolyhedron& b : assembly.stones[overlap.b].parts)
            for (auto& polygon : importers::assembly::shared_region(a, b))
                mark.polygons.push_back(std::move(polygon));
    return mark;
}

importers::mesh::MarkedFeature outline_of(const importers::assembly::AssemblyStone& stone,
                                          const std::string& label)
{
    importers::mesh::MarkedFeature mark{label, {}, {}, {}};
    for (const ConvexPolyhedron& part : stone.parts)
        for (const ConvexPolyhedron::Edge& edge : part.edges)
            if (!part.is_glued(edge)) mark.lines.push_back({part.vertices[edge.from], part.vertices[edge.to]});
    return mark;
}

importers::mesh::MarkedFeature contact_mark(const importers::assembly::StoneContact& contact,
                                            const std::string& label)
{
    importers::mesh::MarkedFeature mark{label, {}, {}, {}};
    for (const std::vector<Vector3d>& polygon : contact.polygons) {
        if (polygon.size() == 1) mark.points.push_back(polygon.front());
        if (polygon.size() >= 3) mark.polygons.push_back(polygon);
    }
    return mark;
}

bool overlaps_matter(const importers::assembly::Assembly& assembly)
{
    return std::any_of(assembly.findings.begin(), assembly.findings.end(),
                       [](const importers::assembly::AssemblyFinding& finding) {
                           return finding.kind == "overlaps" && !finding.harmless;
                       });
}

}  // namespace voussoir::app::commands
