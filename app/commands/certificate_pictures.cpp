#include <fmt/format.h>

#include <algorithm>

#include "app/commands/certificate.h"
#include "app/commands/picture_album.h"
#include "app/commands/say.h"
#include "libdda/errors.h"

namespace voussoir::app::commands
{
namespace
{

namespace fs = std::filesystem;
using Eigen::Vector3d;

void draw_refused(Album& album)
{
    int shape = static_cast<int>(album.assembly.stones.size());
    for (const importers::helper::Stone* stone : album.defects) {
        render::DefectPicture picture;
        const bool refused = !stone->reason.empty();
        picture.title = fmt::format("{}: {}", stone->name, refused ? "refused" : "accepted, with a mark");
        picture.subtitle = album.title;
        picture.stones.push_back({shape++, render::StoneLook::faulty});
        for (const importers::mesh::MarkedFeature& feature : stone->features)
            picture.marks.push_back({feature, render::MarkLook::defect});
        picture.legend.emplace_back(render::StoneLook::faulty, refused ? "refused stone" : "stone");
        picture.mark_legend.emplace_back(render::MarkLook::defect, "what is wrong");
        if (refused) picture.notes.push_back(stone->reason);
        for (const importers::mesh::Repair& repair : stone->repairs)
            picture.notes.push_back("repaired: " + repair.text);
        add_picture(std::move(picture), stone->name, album);
    }
}

constexpr std::size_t max_overlaps = 8;

void draw_overlaps(Album& album)
{
    if (!overlaps_matter(album.assembly)) return;
    std::vector<importers::assembly::StoneOverlap> overlaps = album.assembly.overlaps;
    std::stable_sort(overlaps.begin(), overlaps.end(),
                     [](const importers::assembly::StoneOverlap& a, const importers::assembly::StoneOverlap& b) {
                         return a.volume > b.volume;
                     });
    if (overlaps.size() > max_overlaps) {  // other findings want pictures too
        album.left_out += overlaps.size() - max_overlaps;
        overlaps.resize(max_overlaps);
    }
    for (const importers::assembly::StoneOverlap& overlap : overlaps) {
        render::DefectPicture picture = pair_picture(album, overlap.a, overlap.b, "they overlap");
        picture.marks.push_back({overlap_mark(album.assembly, overlap), render::MarkLook::defect});
        picture.mark_legend.emplace_back(render::MarkLook::defect, "region occupied by both");
        picture.notes = notes_about(album.assembly, "overlaps", overlap.a);
        add_picture(std::move(picture),
                    album.assembly.stones[overlap.a].name + "_" + album.assembly.stones[overlap.b].name, album);
    }
}

void draw_floating(Album& album)
{
    for (const int i : album.assembly.floating) {
        const importers::assembly::AssemblyStone& stone = album.assembly.stones[i];
        render::DefectPicture picture;
        picture.title = stone.name + ": touches no other stone";
        picture.subtitle = album.title;
        picture.stones.push_back({i, render::StoneLook::floating});
        picture.legend.emplace_back(render::StoneLook::floating, "floating stone");
        picture.marks.push_back({outline_of(stone, "touches none"), render::MarkLook::defect});
        picture.frame_ghosts = true;
        bool near = false;
        for (const importers::assembly::StoneGap& gap : album.assembly.gaps) {
            if (gap.a != i && gap.b != i) continue;
            const std::string& other = album.assembly.stones[gap.a == i ? gap.b : gap.a].name;
            picture.marks.push_back(
                {{importers::assembly::length_words(gap.width) + " to " + other, {}, {}, gap.polygons},
                 render::MarkLook::gap});
            near = true;
        }
        if (near) picture.mark_legend.emplace_back(render::MarkLook::gap, "gap to a neighbour");
        picture.notes = notes_about(album.assembly, "floating", i);
        add_picture(std::move(picture), stone.name, album);
    }
}

void draw_gaps(Album& album)
{
    for (const importers::assembly::GapGroup& group : album.assembly.gap_groups) {
        const importers::assembly::StoneGap& gap =
            album.assembly.gaps[*std::max_element(group.gaps.begin(), group.gaps.end(), [&](int x, int y) {
                return album.assembly.gaps[x].area < album.assembly.gaps[y].area;
            })];
        render::DefectPicture picture =
            pair_picture(album, gap.a, gap.b, importers::assembly::length_words(gap.width) + " apart");
        if (group.gaps.size() > 1)
            picture.title +=
                fmt::format(" (and {} like it)",
                            group.gaps.size() == 2 ? "1 pair" : fmt::format("{} pairs", group.gaps.size() - 1));
        picture.marks.push_back({{importers::assembly::length_words(gap.width) + " apart", {}, {}, gap.polygons},
                                 render::MarkLook::gap});
        picture.mark_legend.emplace_back(render::MarkLook::gap, "facing area, half way");
        for (const importers::assembly::AssemblyFinding& finding : album.assembly.findings)
            if (finding.kind == "gaps" && &group - album.assembly.gap_groups.data() ==
                                              std::count_if(album.assembly.findings.data(), &finding,
                                                            [](const auto& f) { return f.kind == "gaps"; }))
                picture.notes = {finding.what, "Remedy: " + finding.advice};
        add_picture(std::move(picture),
                    album.assembly.stones[gap.a].name + "_" + album.assembly.stones[gap.b].name, album);
    }
}

void draw_poor_contacts(Album& album)
{
    for (const importers::assembly::StoneContact& contact : album.assembly.contacts) {
        if (contact.touch == importers::assembly::Touch::face) continue;
        const bool tilted = contact.touch == importers::assembly::Touch::tilted;
        render::DefectPicture picture =
            pair_picture(album, contact.a, contact.b, tilted ? "edge contact only" : "hardly touch");
        const std::string label = tilted ? "open up to " + importers::assembly::length_words(contact.largest_gap)
                                         : fmt::format("{:.2g} m2 touch", contact.area);
        picture.marks.push_back({contact_mark(contact, label), render::MarkLook::contact});
        picture.mark_legend.emplace_back(render::MarkLook::contact, "faces that should touch");
        picture.notes = notes_about(album.assembly, tilted ? "tilted" : "small contact", contact.a);
        add_picture(std::move(picture),
                    album.assembly.stones[contact.a].name + "_" + album.assembly.stones[contact.b].name, album);
    }
}

void draw_slivers(Album& album)
{
    for (const importers::assembly::SliverStone& sliver : album.assembly.slivers) {
        const importers::assembly::AssemblyStone& stone = album.assembly.stones[sliver.stone];
        render::DefectPicture picture;
        picture.title = stone.name + (sliver.thin ? ": a sliver" : ": a very short edge");
        picture.subtitle = album.title;
        picture.stones.push_back({sliver.stone, render::StoneLook::faulty});
        picture.legend.emplace_back(render::StoneLook::faulty, stone.name);
        importers::mesh::MarkedFeature mark{
            sliver.thin ? fmt::format("{} thin, 1:{:.0f}", importers::assembly::length_words(sliver.width),
                                      sliver.diameter / sliver.width)
                        : "edge of " + importers::assembly::length_words(sliver.shortest_edge),
            {},
            {},
            {}};
        for (const std::vector<Vector3d>& polygon : sliver.marks) {
            if (polygon.size() == 2) mark.lines.push_back({polygon[0], polygon[1]});
            if (polygon.size() > 2) mark.polygons.push_back(polygon);
        }
        picture.marks.push_back({mark, render::MarkLook::defect});
        picture.notes = notes_about(album.assembly, sliver.thin ? "slivers" : "short edges", sliver.stone);
        add_picture(std::move(picture), stone.name, album);
    }
}

void draw_unsupported(Album& album)
{
    render::DefectPicture picture;
    const importers::assembly::Assembly& assembly = album.assembly;
    for (const int i : assembly.unsupported)
        if (!std::binary_search(assembly.floating.begin(), assembly.floating.end(), i))
            picture.stones.push_back({i, render::StoneLook::floating});
    if (picture.stones.empty()) return;
    const std::string name = assembly.stones[picture.stones.front().shape].name;
    picture.title = fmt::format("{} stones without a path to the ground", picture.stones.size());
    picture.subtitle = album.title;
    picture.legend.emplace_back(render::StoneLook::floating, "unsupported stones");
    picture.frame_ghosts = true;
    picture.notes = notes_about(assembly, "unsupported", picture.stones.front().shape);
    picture.marks.push_back({outline_of(assembly.stones[picture.stones.front().shape], "no path to the ground"),
                             render::MarkLook::defect});
    add_picture(std::move(picture), "unsupported_" + name, album);
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

bool draw_certificate(const std::string& title, const importers::assembly::Assembly& assembly,
                      const std::vector<importers::helper::ImportedMesh>& meshes, const fs::path& folder)
{
    Album album{title, assembly, {}, {}, {}, 0};
    for (const importers::assembly::AssemblyStone& stone : assembly.stones)
        add_shape(shape_of(stone.parts), album);
    for (const importers::helper::ImportedMesh& mesh : meshes)
        for (const importers::helper::Stone& stone : mesh.stones) {
            if (stone.vertices.empty()) continue;
            album.defects.push_back(&stone);
            add_shape({stone.vertices, stone.faces}, album);
        }
    remove_earlier(folder);
    if (album.pictures.shapes.empty()) return true;
    add_whole(album);
    draw_refused(album);
    draw_overlaps(album);
    draw_floating(album);
    draw_unsupported(album);
    draw_gaps(album);
    draw_slivers(album);
    draw_poor_contacts(album);
    if (album.left_out > 0)
        complain(
            fmt::format("note: {} more findings have no picture: repair some and check again", album.left_out));
    try {
        render::draw_defects(album.pictures, folder);
        return true;
    } catch (const InputError& error) {
        complain(fmt::format("warning: {}", error.what()));
        return !render::can_draw_defects();
    }
}

}  // namespace voussoir::app::commands
