#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "app/commands/picture_album.h"

namespace voussoir::app::commands
{
namespace
{

constexpr std::size_t max_marks = 3000;

/// Marks of all findings on the whole, with one callout for each group.
void mark_findings(const importers::assembly::Assembly& assembly, render::DefectPicture& picture)
{
    for (const importers::assembly::GapGroup& group : assembly.gap_groups)
        for (std::size_t i = 0; i < group.gaps.size() && picture.marks.size() < max_marks; ++i)
            picture.marks.push_back(
                {{i == group.gaps.size() / 2
                      ? fmt::format("{} pair{} {} apart", group.gaps.size(), group.gaps.size() == 1 ? "" : "s",
                                    importers::assembly::length_words(assembly.gaps[group.gaps[i]].width))
                      : "",
                  {},
                  {},
                  assembly.gaps[group.gaps[i]].polygons},
                 render::MarkLook::gap});
    const bool overlaps = overlaps_matter(assembly);
    for (const importers::assembly::StoneOverlap& overlap : assembly.overlaps)
        if (overlaps && picture.marks.size() < max_marks)
            picture.marks.push_back({overlap_mark(assembly, overlap), render::MarkLook::defect});
    for (const int stone : assembly.floating) {
        const importers::mesh::MarkedFeature outline = outline_of(assembly.stones[stone], "touches none");
        if (picture.marks.size() < max_marks) picture.marks.push_back({outline, render::MarkLook::defect});
    }
    for (const importers::assembly::StoneContact& contact : assembly.contacts)
        if (contact.touch == importers::assembly::Touch::tilted && picture.marks.size() < max_marks)
            picture.marks.push_back({contact_mark(contact, ""), render::MarkLook::contact});
    const bool tilted = std::any_of(
        assembly.contacts.begin(), assembly.contacts.end(),
        [](const importers::assembly::StoneContact& c) { return c.touch == importers::assembly::Touch::tilted; });
    if (!assembly.gaps.empty()) picture.mark_legend.emplace_back(render::MarkLook::gap, "gap");
    if (overlaps || !assembly.floating.empty())
        picture.mark_legend.emplace_back(render::MarkLook::defect, "overlap, floating stone");
    if (tilted) picture.mark_legend.emplace_back(render::MarkLook::contact, "edge contact only");
}

bool is_loose(const importers::assembly::Assembly& assembly, int stone)
{
    return std::binary_search(assembly.unsupported.begin(), assembly.unsupported.end(), stone) ||
           std::binary_search(assembly.floating.begin(), assembly.floating.end(), stone);
}

}  // namespace

void add_whole(Album& album)
{
    const importers::assembly::Assembly& assembly = album.assembly;
    render::DefectPicture picture;
    picture.name = "assembly.png";
    picture.title = album.title;
    picture.subtitle =
        fmt::format("{} stone{}, {}", assembly.stones.size(), assembly.stones.size() == 1 ? "" : "s",
                    assembly.contacts.size() == 1 ? "1 pair touches"
                                                  : fmt::format("{} pairs touch", assembly.contacts.size()));
    if (!album.defects.empty()) picture.subtitle += fmt::format(", {} only marked", album.defects.size());
    std::set<render::StoneLook> used;
    for (int i = 0; i < static_cast<int>(album.pictures.shapes.size()); ++i) {
        render::StoneLook look = render::StoneLook::plain;
        if (i >= static_cast<int>(assembly.stones.size()))
            look = render::StoneLook::faulty;
        else if (is_loose(assembly, i))
            look = render::StoneLook::floating;
        else if (assembly.ground_given && std::binary_search(assembly.ground.begin(), assembly.ground.end(), i))
            look = render::StoneLook::ground;
        used.insert(look);
        picture.stones.push_back({i, look});
    }
    if (used.contains(render::StoneLook::plain)) picture.legend.emplace_back(render::StoneLook::plain, "stone");
    if (used.contains(render::StoneLook::ground))
        picture.legend.emplace_back(render::StoneLook::ground, "foundation");
    if (used.contains(render::StoneLook::faulty))
        picture.legend.emplace_back(render::StoneLook::faulty, "stone with its own picture");
    if (used.contains(render::StoneLook::floating))
        picture.legend.emplace_back(render::StoneLook::floating, "no contact, or no path to the ground");
    mark_findings(assembly, picture);
    for (const importers::assembly::AssemblyFinding& finding : assembly.findings)
        if (!finding.harmless) picture.notes.push_back(finding.what);
    if (picture.notes.empty() && album.defects.empty())
        picture.notes.emplace_back("No faults were found in the assembly of the stones.");
    album.pictures.pictures.push_back(std::move(picture));
}

}  // namespace voussoir::app::commands
