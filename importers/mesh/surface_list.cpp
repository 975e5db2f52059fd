#include <algorithm>

#include "importers/mesh/formats.h"
#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

/// `"a", "b" and 17 others`
std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(names.size(), 3); ++i)
        text += (i > 0 ? ", " : "") + names[i];
    return names.size() > 3 ? text + " and " + std::to_string(names.size() - 3) + " others" : text;
}

}  // namespace

int checked_index(long long index, std::size_t count, const std::string& place)
{
    if (index >= 0 && static_cast<unsigned long long>(index) < count) return static_cast<int>(index);
    throw InputError(place, "a face names vertex " + std::to_string(index) + ", counted from 0",
                     "the mesh has " + std::to_string(count) + " vertices");
}

void append(const PolygonSurface& part, PolygonSurface& whole)
{
    const int first = static_cast<int>(whole.vertices.size());
    whole.vertices.insert(whole.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (std::vector<int> face : part.faces) {
        for (int& v : face) v += first;
        whole.faces.push_back(std::move(face));
    }
}

void SurfaceList::add(PolygonSurface surface, const Eigen::Affine3d& placement)
{
    const std::string own = text::as_utf8(text::trim(surface.name));
    const std::string wanted = own.empty() ? default_name_ : own;
    faces_left_out_ += std::erase_if(surface.faces, [](const auto& face) { return face.size() < 3; });
    if (surface.faces.empty()) return note("\"" + wanted + "\" has no faces and was left out");
    const std::string place = place_ + ": " + wanted;
    const bool moves = !placement.isApprox(Eigen::Affine3d::Identity(), 0);
    for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
        if (moves) surface.vertices[v] = placement * surface.vertices[v];
        if (!surface.vertices[v].allFinite())
            throw InputError(place, "vertex " + std::to_string(v) + " is not finite",
                             "coordinates and transforms must be finite numbers");
    }
    const bool mirrors = placement.linear().determinant() < 0;
    for (std::vector<int>& face : surface.faces) {
        for (const int v : face) checked_index(v, surface.vertices.size(), place);
        if (mirrors) std::reverse(face.begin(), face.end());
    }
    surface.name = merge_ ? wanted : unique(wanted);
    if (mirrors) mirrored_.push_back("\"" + surface.name + "\"");
    keep(std::move(surface));
}

void SurfaceList::keep(PolygonSurface surface)
{
    const auto [known, is_new] = index_.emplace(surface.name, surfaces_.size());
    if (is_new)
        surfaces_.push_back(std::move(surface));
    else
        append(surface, surfaces_[known->second]);
}

std::string SurfaceList::unique(const std::string& wanted)
{
    std::string name = wanted;
    for (int& copy = copies_[wanted]; copy > 0 && copies_.contains(name);)
        name = wanted + " (" + std::to_string(++copy) + ")";
    copies_[wanted] = std::max(copies_[wanted], 1);
    if (name == wanted) return name;
    copies_[name] = 1;
    renamed_.push_back("\"" + name + "\"");
    return name;
}

MeshFile SurfaceList::finish()
{
    if (surfaces_.empty()) throw InputError(place_, "the file holds no faces", "a stone is a closed surface");
    if (!renamed_.empty()) note("objects with the name of another one were renamed: " + listed(renamed_));
    if (!mirrored_.empty())
        note("the transform of its node mirrors the mesh, so its faces were turned: " + listed(mirrored_));
    if (faces_left_out_ > 0)
        note(std::to_string(faces_left_out_) + " faces of fewer than three corners were left out");
    MeshFile file;
    file.surfaces = std::move(surfaces_);
    file.repairs = std::move(repairs_);
    return file;
}

}  // namespace voussoir::importers::mesh
