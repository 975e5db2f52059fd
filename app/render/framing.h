// What all pictures of a run share: one camera, one colour scale, the same words.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <limits>
#include <optional>
#include <vector>

#include "app/drawing/color_map.h"
#include "app/render/camera.h"
#include "app/render/page.h"
#include "app/render/scene.h"

namespace voussoir::app::render
{

/// Gathered scene by scene.
class Framing
{
 public:
    explicit Framing(SnapshotColor color) : color_(color) {}

    /// The first scene tells how large the structure is. @param in_sight the camera must see it
    void add(const Scene& scene, bool in_sight = true);

    /// Sees the structure, the foundations no further out than a quarter of the structure's size, and fallen
    /// blocks no further than that size. @param planar seen as an elevation; @param strip with room for one
    /// @param orbited [rad] how far the viewer has turned
    Camera camera(int width, int height, bool planar, bool strip = false, const Look& look = {},
                  double orbited = 0) const;
    /// From the smallest value to the largest; from zero but for stresses.
    drawing::ColorScale scale() const;

 private:
    SnapshotColor color_;
    Eigen::AlignedBox3d built_;  // m, the structure in the first scene
    std::vector<Eigen::Vector3d> points_;
    double lowest_ = std::numeric_limits<double>::infinity(), highest_ = -std::numeric_limits<double>::infinity();
};

/// The scale of the framing, or the names of the groups with their colours.
drawing::ColorScale scale_of(const Framing& framing, const LookOfRun& look);

/// The camera at a later moment: it has gone as far as what it follows, so that this stays where it is in the
/// picture. The same camera where it follows nothing. @param followed_at_start [m] in the scene it was made for
Camera moved_with(const Camera& camera, const Scene& scene,
                  const std::optional<Eigen::Vector3d>& followed_at_start);

/// Where in the picture the labels are.
std::vector<PlacedWord> placed_labels(const Scene& scene, const Camera& camera);

/// Title, time, legend and notes of a picture.
PageText words_of(const Scene& scene, const results::RecordedModel& model, const SceneOptions& options);

/// @throws InputError when the results hold no frame, no block, or not what the colours are to show
void expect_drawable(const results::ResultsReader& results, const std::filesystem::path& file,
                     SnapshotColor color);

/// The first frame of a dynamic stage; 0 when the run has none.
std::size_t first_dynamic_frame(const results::ResultsReader& results);

}  // namespace voussoir::app::render
