#include "importers/helper/geometry.h"

#include <exception>
#include <stdexcept>

#include "importers/helper/wire.h"
#include "importers/process/child_process.h"
#include "libdda/errors.h"

namespace voussoir::importers::helper
{

namespace
{

// Twenty times what 10,000 stones need; as a tree in memory it takes some sixteen times as much.
constexpr std::size_t max_answer_bytes = std::size_t{1} << 28;

/// One run of the helper. @param failure why there is no answer, in words
Geometry ask_helper(const std::vector<MeshRequest>& requests, const GeometryLimits& limits, std::string& failure)
{
    // The limit is per file, so that many files are not refused for being many.
    GeometryLimits all = limits;
    all.seconds *= static_cast<double>(requests.size());
    const process::ChildAnswer answer =
        process::ask_child(process::helper_folder() / "voussoir-geometry", to_json(HelperRequest{requests, all}),
                           all.seconds, max_answer_bytes);
    failure = answer.failure;
    if (!failure.empty()) return {};
    try {
        Geometry geometry = geometry_from_json(answer.output);
        if (geometry.meshes.size() == requests.size()) return geometry;
        failure = "it answered for another number of files";
    } catch (const std::exception& error) {
        failure = std::string("its answer is invalid: ") + error.what();
    }
    return {};
}

ImportedMesh refused(const MeshRequest& request, const std::string& failure)
{
    ImportedMesh mesh;
    mesh.file = request.file.string();
    mesh.reason = "the geometry helper gave no answer: " + failure;
    if (request.metres_per_unit > 0) mesh.metres_per_unit = request.metres_per_unit;
    return mesh;
}

}  // namespace

Geometry import_geometry(const std::vector<MeshRequest>& requests, const GeometryLimits& limits)
{
    if (requests.empty()) return {};
    std::string failure;
    Geometry geometry = ask_helper(requests, limits, failure);
    if (failure.empty()) return geometry;
    if (requests.size() == 1) return {Eigen::Vector3d::Zero(), {refused(requests.front(), failure)}, {}, {}};

    // Some file kills the helper: each is asked for alone, and those that live are asked for together again.
    std::vector<MeshRequest> survivors;
    std::vector<ImportedMesh> alone;
    std::vector<bool> survived;
    for (const MeshRequest& request : requests) {
        alone.push_back(import_geometry({request}, limits).meshes.front());
        survived.push_back(alone.back().accepted || !alone.back().stones.empty());
        if (survived.back()) survivors.push_back(request);
    }
    if (survivors.size() < requests.size()) {
        geometry = import_geometry(survivors, limits);
    } else {  // each alone is fine, together they are too much
        for (std::size_t i = 0; i < requests.size(); ++i) alone[i] = refused(requests[i], failure);
        survived.assign(requests.size(), false);
    }
    auto survivor = geometry.meshes.begin();
    std::vector<ImportedMesh> merged;
    for (std::size_t i = 0; i < requests.size(); ++i) merged.push_back(survived[i] ? *survivor++ : alone[i]);
    geometry.meshes = std::move(merged);
    return geometry;
}

std::vector<mesh::MeshFormat> list_mesh_formats()
{
    const process::ChildAnswer answer =
        process::ask_child(process::helper_folder() / "voussoir-geometry", formats_request(),
                           GeometryLimits{}.seconds, max_answer_bytes);
    if (answer.failure.empty()) return formats_from_json(answer.output);
    throw std::runtime_error("the geometry helper gave no answer: " + answer.failure);
}

}  // namespace voussoir::importers::helper
