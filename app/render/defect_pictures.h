// Pictures of stones with what is wrong with them marked, drawn by the helper program `voussoir-defects`. Nothing
// of it is loaded here.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "importers/helper/geometry.h"

namespace voussoir::app::render
{

/// How a stone is drawn.
enum class StoneLook {
    plain,     // a sound stone
    ground,    // carries the others
    faulty,    // the stone the picture is about
    first,     // of a pair, seen through
    second,    // of a pair, seen through
    floating,  // touches none
    ghost,     // a neighbour, nearly invisible
};
constexpr int stone_looks = 7;

/// Colours of marks.
enum class MarkLook { defect, gap, contact };
constexpr int mark_looks = 3;

struct PictureShape {
    std::vector<Eigen::Vector3d> vertices;  // m
    std::vector<std::vector<int>> faces;
};

struct PictureStone {
    int shape = 0;  // index into DefectPictures::shapes
    StoneLook look = StoneLook::plain;
};

struct PictureMark {
    importers::mesh::MarkedFeature feature;  // without a label it gets no callout
    MarkLook look = MarkLook::defect;
};

struct DefectPicture {
    std::string name;  // of the file, without folder
    std::string title, subtitle;
    std::vector<PictureStone> stones;
    std::vector<PictureMark> marks;
    std::vector<std::pair<StoneLook, std::string>> legend;
    std::vector<std::pair<MarkLook, std::string>> mark_legend;
    std::vector<std::string> notes;  // paragraphs below the drawing
    bool frame_ghosts = false;       // neighbours are in the picture as a whole
};

struct DefectPictures {
    int width = 1400, height = 1000;  // pixels
    std::vector<PictureShape> shapes;
    std::vector<DefectPicture> pictures;
};

/// Is there the helper that draws them?
bool can_draw_defects();

/// Starts `voussoir-defects` (beside the running program), which draws the pictures into `folder`.
/// @returns the files it made
/// @throws InputError when the helper is missing or fails
std::vector<std::filesystem::path> draw_defects(const DefectPictures& pictures,
                                                const std::filesystem::path& folder);

/// What the program and its helper say to each other: JSON text.
std::string to_json(const DefectPictures& pictures, const std::filesystem::path& folder);

struct DefectRequest {
    DefectPictures pictures;
    std::filesystem::path folder;
};

/// @throws std::exception when the text is not what to_json wrote
DefectRequest defects_from_json(const std::string& text);

}  // namespace voussoir::app::render
