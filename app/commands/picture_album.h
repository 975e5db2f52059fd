// The pictures of a certificate while they are made.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "app/render/defect_pictures.h"
#include "importers/assembly/assembly.h"

namespace voussoir::app::commands
{

/// Pictures while they are made: the shapes of all stones, those of the assembly first.
struct Album {
    const std::string& title;
    const importers::assembly::Assembly& assembly;
    render::DefectPictures pictures;
    std::vector<Eigen::AlignedBox3d> bounds;  // of each shape
    std::vector<const importers::helper::Stone*>
        defects;  // stones with features; their shapes follow those of the assembly
    std::size_t left_out = 0;
};

/// The stone's own faces, without those between its parts.
render::PictureShape shape_of(const std::vector<ConvexPolyhedron>& parts);

void add_shape(render::PictureShape shape, Album& album);

/// Adds a picture of some stones with their neighbours, or counts it as left out when there are many already.
void add_picture(render::DefectPicture picture, const std::string& name, Album& album);

/// False when all overlaps are shallower than the contact tolerance: marked, they would hide what matters.
bool overlaps_matter(const importers::assembly::Assembly& assembly);

/// The picture of the whole assembly, with a mark for each finding.
void add_whole(Album& album);

/// A picture of a pair of stones, both seen through.
render::DefectPicture pair_picture(const Album& album, int a, int b, const std::string& words);

/// What was found of this kind about this stone, and what to do: the words below a picture.
std::vector<std::string> notes_about(const importers::assembly::Assembly& assembly, const std::string& kind,
                                     int stone);

// Marks: the space that two stones share, all edges of a stone, the faces of a contact.
importers::mesh::MarkedFeature overlap_mark(const importers::assembly::Assembly& assembly,
                                            const importers::assembly::StoneOverlap& overlap);
importers::mesh::MarkedFeature outline_of(const importers::assembly::AssemblyStone& stone,
                                          const std::string& label);
importers::mesh::MarkedFeature contact_mark(const importers::assembly::StoneContact& contact,
                                            const std::string& label);

}  // namespace voussoir::app::commands
