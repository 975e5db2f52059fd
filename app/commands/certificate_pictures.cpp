#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "app/commands/certificate.h"
#include "app/render/defect_pictures.h"
#include "libdda/errors.h"

namespace voussoir
{
namespace
{

namespace fs = std::filesystem;
using Eigen::Vector3d;
using Box = Eigen::AlignedBox3d;

constexpr std::size_t most_pictures = 20, most_neighbours = 60, least_context = 12, most_marks = 3000;
constexpr double neighbourhood = 0.25;  // of the diagonal of what the picture is about

/// Pictures while they are made: the shapes of all stones, those of the assembly first.
struct Album {
    const std::string& title;
    const Assembly& assembly;
    DefectPictures pictures;
    std::vector<Box> bounds;            // of each shape
    std::vector<const Stone*> defects;  // stones with features; their shapes follow those of the assembly
    std::size_t left_out = 0;
};

PictureShape shape_of(const std::vector<ConvexPolyhedron>& parts)
{
    PictureShape shape;
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

void add_shape(PictureShape shape, Album& album)
{
    Box box;
    for (const Vector3d& x : shape.vertices) box.extend(x);
    album.bounds.push_back(box);
    album.pictures.shapes.push_back(std::move(shape));
}

/// "defect_03_stone_7.png"; letters that file systems or shells dislike become underscores.
std::string file_name(std::size_t number, const std::string& name)
{
    std::string safe = name.substr(0, 60);
    for (char& c : safe)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
    return fmt::format("defect_{:02}_{}.png", number, safe);
}

/// Stones around those of the picture, as ghosts, the nearest first.
void add_neighbours(const Album& album, DefectPicture& picture)
{
    Box box;
    std::set<int> shown;
    for (const PictureStone& stone : picture.stones) {
        box.extend(album.bounds[stone.shape]);
        shown.insert(stone.shape);
    }
    const double reach = neighbourhood * box.diagonal().norm();
    std::vector<std::pair<double, int>> near;
    for (int i = 0; i < static_cast<int>(album.bounds.size()); ++i)
        if (!shown.contains(i)) near.emplace_back(box.exteriorDistance(album.bounds[i]), i);
    std::sort(near.begin(), near.end());
    std::size_t count = 0;
    while (count < near.size() && count < most_neighbours && near[count].first < reach) ++count;
    if (picture.frame_ghosts) count = std::min(near.size(), std::max(count, least_context));
    near.resize(count);
    for (const auto& [distance, shape] : near) picture.stones.push_back({shape, StoneLook::ghost});
    if (!near.empty()) picture.legend.emplace_back(StoneLook::ghost, "neighbours");
}

void add_picture(DefectPicture picture, const std::string& name, Album& album)
{
    if (album.pictures.pictures.size() > most_pictures) {
        ++album.left_out;
        return;
    }
    add_neighbours(album, picture);
    picture.name = file_name(album.pictures.pictures.size(), name);
    album.pictures.pictures.push_back(std::move(picture));
}

/// What the words of a finding of this kind about this stone are, for the notes.
std::vector<std::string> notes_about(const Assembly& assembly, const std::string& kind, int stone)
{
    for (const AssemblyFinding& finding : assembly.findings)
        if (finding.kind == kind &&
            std::find(finding.stones.begin(), finding.stones.end(), stone) != finding.stones.end())
            return {finding.what, "What to do: " + finding.advice};
    return {};
}

void draw_refused(Album& album)
{
    int shape = static_cast<int>(album.assembly.stones.size());
    for (const Stone* stone : album.defects) {
        DefectPicture picture;
        const bool refused = !stone->reason.empty();
        picture.title = fmt::format("{}: {}", stone->name, refused ? "refused" : "accepted, with a mark");
        picture.subtitle = album.title;
        picture.stones.push_back({shape++, StoneLook::faulty});
        for (const MarkedFeature& feature : stone->features) picture.marks.push_back({feature, MarkLook::defect});
        picture.legend.emplace_back(StoneLook::faulty, refused ? "refused stone" : "stone");
        picture.mark_legend.emplace_back(MarkLook::defect, "what is wrong");
        if (refused) picture.notes.push_back(stone->reason);
        for (const std::string& repair : stone->repairs) picture.notes.push_back("repaired: " + repair);
        add_picture(std::move(picture), stone->name, album);
    }
}

/// A picture of a pair of stones, both seen through.
DefectPicture pair_picture(const Album& album, int a, int b, const std::string& words)
{
    DefectPicture picture;
    const std::string &name_a = album.assembly.stones[a].name, &name_b = album.assembly.stones[b].name;
    picture.title = fmt::format("{} and {}: {}", name_a, name_b, words);
    picture.subtitle = album.title;
    picture.stones = {{a, StoneLook::first}, {b, StoneLook::second}};
    picture.legend = {{StoneLook::first, name_a}, {StoneLook::second, name_b}};
    return picture;
}

MarkedFeature overlap_mark(const Assembly& assembly, const StoneOverlap& overlap)
{
    MarkedFeature mark{fmt::format("shared: {:.3g} m3", overlap.volume), {}, {}, {}};
    if (overlap.depth > 0) mark.label += ", " + length_words(overlap.depth) + " deep";
    for (const ConvexPolyhedron& a : assembly.stones[overlap.a].parts)
        for (const ConvexPolyhedron& b : assembly.stones[overlap.b].parts)
            for (auto& polygon : shared_region(a, b)) mark.polygons.push_back(std::move(polygon));
    return mark;
}

void draw_overlaps(Album& album)
{
    for (const StoneOverlap& overlap : album.assembly.overlaps) {
        DefectPicture picture = pair_picture(album, overlap.a, overlap.b, "they overlap");
        picture.marks.push_back({overlap_mark(album.assembly, overlap), MarkLook::defect});
        picture.mark_legend.emplace_back(MarkLook::defect, "space that both take");
        picture.notes = notes_about(album.assembly, "overlaps", overlap.a);
        add_picture(std::move(picture),
                    album.assembly.stones[overlap.a].name + "_" + album.assembly.stones[overlap.b].name, album);
    }
}

/// All edges of a stone.
MarkedFeature outline_of(const AssemblyStone& stone, const std::string& label)
{
    MarkedFeature mark{label, {}, {}, {}};
    for (const ConvexPolyhedron& part : stone.parts)
        for (const ConvexPolyhedron::Edge& edge : part.edges)
            if (!part.is_glued(edge)) mark.lines.push_back({part.vertices[edge.from], part.vertices[edge.to]});
    return mark;
}

void draw_floating(Album& album)
{
    for (const int i : album.assembly.floating) {
        const AssemblyStone& stone = album.assembly.stones[i];
        DefectPicture picture;
        picture.title = stone.name + ": touches no other stone";
        picture.subtitle = album.title;
        picture.stones.push_back({i, StoneLook::floating});
        picture.legend.emplace_back(StoneLook::floating, "floating stone");
        picture.marks.push_back({outline_of(stone, "touches none"), MarkLook::defect});
        picture.frame_ghosts = true;
        bool near = false;
        for (const StoneGap& gap : album.assembly.gaps) {
            if (gap.a != i && gap.b != i) continue;
            const std::string& other = album.assembly.stones[gap.a == i ? gap.b : gap.a].name;
            picture.marks.push_back(
                {{length_words(gap.width) + " to " + other, {}, {}, gap.polygons}, MarkLook::gap});
            near = true;
        }
        if (near) picture.mark_legend.emplace_back(MarkLook::gap, "gap to a neighbour");
        picture.notes = notes_about(album.assembly, "floating", i);
        add_picture(std::move(picture), stone.name, album);
    }
}

void draw_gaps(Album& album)
{
    for (const GapGroup& group : album.assembly.gap_groups) {
        const StoneGap& gap =
            album.assembly.gaps[*std::max_element(group.gaps.begin(), group.gaps.end(), [&](int x, int y) {
                return album.assembly.gaps[x].area < album.assembly.gaps[y].area;
            })];
        DefectPicture picture = pair_picture(album, gap.a, gap.b, length_words(gap.width) + " apart");
        if (group.gaps.size() > 1) picture.title += fmt::format(" (and {} pairs like it)", group.gaps.size() - 1);
        picture.marks.push_back({{length_words(gap.width) + " apart", {}, {}, gap.polygons}, MarkLook::gap});
        picture.mark_legend.emplace_back(MarkLook::gap, "facing area, half way");
        for (const AssemblyFinding& finding : album.assembly.findings)
            if (finding.kind == "gaps" && &group - album.assembly.gap_groups.data() ==
                                              std::count_if(album.assembly.findings.data(), &finding,
                                                            [](const auto& f) { return f.kind == "gaps"; }))
                picture.notes = {finding.what, "What to do: " + finding.advice};
        add_picture(std::move(picture),
                    album.assembly.stones[gap.a].name + "_" + album.assembly.stones[gap.b].name, album);
    }
}

MarkedFeature contact_mark(const StoneContact& contact, const std::string& label)
{
    MarkedFeature mark{label, {}, {}, {}};
    for (const std::vector<Vector3d>& polygon : contact.polygons) {
        if (polygon.size() == 1) mark.points.push_back(polygon.front());
        if (polygon.size() >= 3) mark.polygons.push_back(polygon);
    }
    return mark;
}

void draw_poor_contacts(Album& album)
{
    for (const StoneContact& contact : album.assembly.contacts) {
        if (contact.touch == Touch::face) continue;
        const bool tilted = contact.touch == Touch::tilted;
        DefectPicture picture =
            pair_picture(album, contact.a, contact.b, tilted ? "an edge touches" : "hardly touch");
        const std::string label = tilted ? "open up to " + length_words(contact.largest_gap)
                                         : fmt::format("{:.2g} m2 touch", contact.area);
        picture.marks.push_back({contact_mark(contact, label), MarkLook::contact});
        picture.mark_legend.emplace_back(MarkLook::contact, "faces that should touch");
        picture.notes = notes_about(album.assembly, tilted ? "tilted" : "small contact", contact.a);
        add_picture(std::move(picture),
                    album.assembly.stones[contact.a].name + "_" + album.assembly.stones[contact.b].name, album);
    }
}

void draw_slivers(Album& album)
{
    for (const SliverStone& sliver : album.assembly.slivers) {
        const AssemblyStone& stone = album.assembly.stones[sliver.stone];
        DefectPicture picture;
        picture.title = stone.name + (sliver.thin ? ": a sliver" : ": a very short edge");
        picture.subtitle = album.title;
        picture.stones.push_back({sliver.stone, StoneLook::faulty});
        picture.legend.emplace_back(StoneLook::faulty, stone.name);
        MarkedFeature mark{sliver.thin ? fmt::format("{} thin, 1:{:.0f}", length_words(sliver.width),
                                                     sliver.diameter / sliver.width)
                                       : "edge of " + length_words(sliver.shortest_edge),
                           {},
                           {},
                           {}};
        for (const std::vector<Vector3d>& polygon : sliver.marks) {
            if (polygon.size() == 2) mark.lines.push_back({polygon[0], polygon[1]});
            if (polygon.size() > 2) mark.polygons.push_back(polygon);
        }
        picture.marks.push_back({mark, MarkLook::defect});
        picture.notes = notes_about(album.assembly, sliver.thin ? "slivers" : "short edges", sliver.stone);
        add_picture(std::move(picture), stone.name, album);
    }
}

void draw_unsupported(Album& album)
{
    DefectPicture picture;
    const Assembly& assembly = album.assembly;
    for (const int i : assembly.unsupported)
        if (!std::binary_search(assembly.floating.begin(), assembly.floating.end(), i))
            picture.stones.push_back({i, StoneLook::floating});
    if (picture.stones.empty()) return;
    const std::string name = assembly.stones[picture.stones.front().shape].name;
    picture.title = fmt::format("{} stones without a path to the ground", picture.stones.size());
    picture.subtitle = album.title;
    picture.legend.emplace_back(StoneLook::floating, "unsupported stones");
    picture.frame_ghosts = true;
    picture.notes = notes_about(assembly, "unsupported", picture.stones.front().shape);
    picture.marks.push_back(
        {outline_of(assembly.stones[picture.stones.front().shape], "no path to the ground"), MarkLook::defect});
    add_picture(std::move(picture), "unsupported_" + name, album);
}

/// Marks of all findings on the whole, with one callout for each group.
void mark_findings(const Assembly& assembly, DefectPicture& picture)
{
    for (const GapGroup& group : assembly.gap_groups)
        for (std::size_t i = 0; i < group.gaps.size() && picture.marks.size() < most_marks; ++i)
            picture.marks.push_back(
                {{i == group.gaps.size() / 2
                      ? fmt::format("{} pair{} {} apart", group.gaps.size(), group.gaps.size() == 1 ? "" : "s",
                                    length_words(assembly.gaps[group.gaps[i]].width))
                      : "",
                  {},
                  {},
                  assembly.gaps[group.gaps[i]].polygons},
                 MarkLook::gap});
    for (const StoneOverlap& overlap : assembly.overlaps)
        if (picture.marks.size() < most_marks)
            picture.marks.push_back({overlap_mark(assembly, overlap), MarkLook::defect});
    for (const int stone : assembly.floating) {
        const MarkedFeature outline = outline_of(assembly.stones[stone], "touches none");
        if (picture.marks.size() < most_marks) picture.marks.push_back({outline, MarkLook::defect});
    }
    for (const StoneContact& contact : assembly.contacts)
        if (contact.touch == Touch::tilted && picture.marks.size() < most_marks)
            picture.marks.push_back({contact_mark(contact, ""), MarkLook::contact});
    const bool tilted = std::any_of(assembly.contacts.begin(), assembly.contacts.end(),
                                    [](const StoneContact& c) { return c.touch == Touch::tilted; });
    if (!assembly.gaps.empty()) picture.mark_legend.emplace_back(MarkLook::gap, "gap");
    if (!assembly.overlaps.empty() || !assembly.floating.empty())
        picture.mark_legend.emplace_back(MarkLook::defect, "overlap, floating stone");
    if (tilted) picture.mark_legend.emplace_back(MarkLook::contact, "an edge touches");
}

bool is_loose(const Assembly& assembly, int stone)
{
    return std::binary_search(assembly.unsupported.begin(), assembly.unsupported.end(), stone) ||
           std::binary_search(assembly.floating.begin(), assembly.floating.end(), stone);
}

void draw_whole(Album& album)
{
    const Assembly& assembly = album.assembly;
    DefectPicture picture;
    picture.name = "assembly.png";
    picture.title = album.title;
    picture.subtitle = fmt::format("{} stones, {} pairs touch", assembly.stones.size(), assembly.contacts.size());
    if (!album.defects.empty()) picture.subtitle += fmt::format(", {} marked by themselves", album.defects.size());
    std::set<StoneLook> used;
    for (int i = 0; i < static_cast<int>(album.pictures.shapes.size()); ++i) {
        StoneLook look = StoneLook::plain;
        if (i >= static_cast<int>(assembly.stones.size()))
            look = StoneLook::faulty;
        else if (is_loose(assembly, i))
            look = StoneLook::floating;
        else if (assembly.ground_given && std::binary_search(assembly.ground.begin(), assembly.ground.end(), i))
            look = StoneLook::ground;
        used.insert(look);
        picture.stones.push_back({i, look});
    }
    if (used.contains(StoneLook::plain)) picture.legend.emplace_back(StoneLook::plain, "stone");
    if (used.contains(StoneLook::ground)) picture.legend.emplace_back(StoneLook::ground, "foundation");
    if (used.contains(StoneLook::faulty))
        picture.legend.emplace_back(StoneLook::faulty, "stone with a picture of its own");
    if (used.contains(StoneLook::floating))
        picture.legend.emplace_back(StoneLook::floating, "touches none, or has no path to the ground");
    mark_findings(assembly, picture);
    for (const AssemblyFinding& finding : assembly.findings)
        if (!finding.harmless) picture.notes.push_back(finding.what);
    if (picture.notes.empty() && album.defects.empty())
        picture.notes.emplace_back("The stones stand together without fault.");
    album.pictures.pictures.push_back(std::move(picture));
}

void remove_earlier(const fs::path& folder)
{
    std::error_code none;
    std::vector<fs::path> stale;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
        const std::string name = entry.path().filename().string();
        if (name == "assembly.png" || (name.starts_with("defect_") && name.ends_with(".png")))
            stale.push_back(entry.path());
    }
    for (const fs::path& path : stale) fs::remove(path, none);
}

}  // namespace

std::vector<fs::path> draw_certificate(const std::string& title, const Assembly& assembly,
                                       const std::vector<ImportedMesh>& meshes, const fs::path& folder)
{
    Album album{title, assembly, {}, {}, {}, 0};
    for (const AssemblyStone& stone : assembly.stones) add_shape(shape_of(stone.parts), album);
    for (const ImportedMesh& mesh : meshes)
        for (const Stone& stone : mesh.stones) {
            if (stone.vertices.empty()) continue;
            album.defects.push_back(&stone);
            add_shape({stone.vertices, stone.faces}, album);
        }
    remove_earlier(folder);
    if (album.pictures.shapes.empty()) return {};
    draw_whole(album);
    draw_refused(album);
    draw_overlaps(album);
    draw_floating(album);
    draw_unsupported(album);
    draw_gaps(album);
    draw_slivers(album);
    draw_poor_contacts(album);
    if (album.left_out > 0)
        fmt::print(stderr, "note: {} more findings have no picture: mend some and look again\n", album.left_out);
    try {
        return draw_defects(album.pictures, folder);
    } catch (const InputError& error) {
        fmt::print(stderr, "warning: {}\n", error.what());
        return {};
    }
}

}  // namespace voussoir
