#include "importers/helper/rock.h"

#include <nlohmann/json.hpp>

#include "importers/process/child_process.h"
#include "libdda/errors.h"

namespace voussoir::importers::helper
{
namespace
{

using nlohmann::json;

constexpr double planarity = 1e-5;  // of corners that were rounded to doubles
constexpr std::size_t max_answer_bytes = std::size_t{1} << 28;

json vector_to_json(const Eigen::Vector3d& x)
{
    return {x.x(), x.y(), x.z()};
}

Eigen::Vector3d vector_from(const json& value)
{
    return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

json parts_to_json(const std::vector<ConvexPolyhedron>& parts)
{
    json list = json::array();
    for (const ConvexPolyhedron& part : parts) {
        json vertices = json::array();
        for (const Eigen::Vector3d& x : part.vertices) vertices.push_back(vector_to_json(x));
        list.push_back({{"vertices", vertices}, {"faces", part.faces}, {"glued", part.glued}});
    }
    return list;
}

std::vector<ConvexPolyhedron> parts_from(const json& list)
{
    std::vector<ConvexPolyhedron> parts;
    for (const json& value : list) {
        std::vector<Eigen::Vector3d> vertices;
        for (const json& x : value.at("vertices")) vertices.push_back(vector_from(x));
        parts.push_back(make_convex_polyhedron(std::move(vertices),
                                               value.at("faces").get<std::vector<std::vector<int>>>(),
                                               "a rock block", planarity));
        parts.back().glued = value.at("glued").get<std::vector<bool>>();
        if (!parts.back().glued.empty() && parts.back().glued.size() != parts.back().faces.size())
            throw InputError("rock", "marks of glued faces do not fit the faces", "one mark a face");
    }
    return parts;
}

}  // namespace

std::string to_json(const exact::RockRequest& request)
{
    json sets = json::array();
    for (const exact::JointSet& set : request.sets)
        sets.push_back({{"normal", vector_to_json(set.normal)},
                        {"origin", vector_to_json(set.origin)},
                        {"spacing", set.spacing},
                        {"scatter", set.scatter},
                        {"persistence", set.persistence}});
    return json{{"rock", parts_to_json(request.domain)}, {"sets", sets},           {"seed", request.seed},
                {"smallest", request.smallest},          {"merge", request.merge}, {"most", request.most}}
        .dump();
}

bool asks_for_rock(const std::string& text)
{
    return json::parse(text).contains("rock");
}

exact::RockRequest rock_request_from_json(const std::string& text)
{
    const json value = json::parse(text);
    exact::RockRequest request;
    request.domain = parts_from(value.at("rock"));
    for (const json& set : value.at("sets"))
        request.sets.push_back({vector_from(set.at("normal")), vector_from(set.at("origin")),
                                set.at("spacing").get<double>(), set.at("scatter").get<double>(),
                                set.at("persistence").get<double>()});
    request.seed = value.at("seed").get<std::uint64_t>();
    request.smallest = value.at("smallest").get<double>();
    request.merge = value.at("merge").get<bool>();
    request.most = value.at("most").get<std::size_t>();
    return request;
}

std::string to_json(const exact::CutRock& rock)
{
    json blocks = json::array();
    for (const exact::RockBlock& block : rock.blocks)
        blocks.push_back({{"parts", parts_to_json(block.parts)}, {"volume", block.volume}});
    return json{{"blocks", blocks},
                {"domain_volume", rock.domain_volume},
                {"volume", rock.volume},
                {"removed", rock.removed},
                {"removed_volume", rock.removed_volume},
                {"merged", rock.merged},
                {"merged_volume", rock.merged_volume}}
        .dump();
}

exact::CutRock rock_from_json(const std::string& text)
{
    const json value = json::parse(text);
    if (value.contains("fault"))
        throw InputError(value.at("place").get<std::string>(), value.at("fault").get<std::string>(),
                         value.at("cure").get<std::string>());
    exact::CutRock rock;
    for (const json& block : value.at("blocks"))
        rock.blocks.push_back({parts_from(block.at("parts")), block.at("volume").get<double>()});
    rock.domain_volume = value.at("domain_volume").get<double>();
    rock.volume = value.at("volume").get<double>();
    rock.removed = value.at("removed").get<int>();
    rock.removed_volume = value.at("removed_volume").get<double>();
    rock.merged = value.at("merged").get<int>();
    rock.merged_volume = value.at("merged_volume").get<double>();
    return rock;
}

exact::CutRock ask_for_rock(const exact::RockRequest& request, const GeometryLimits& limits)
{
    const process::ChildAnswer answer = process::ask_child(process::helper_folder() / "voussoir-geometry",
                                                           to_json(request), limits.seconds, max_answer_bytes);
    if (!answer.failure.empty())
        throw InputError("sets", "the geometry helper gave no answer: " + answer.failure,
                         "give larger spacings or a smaller domain");
    try {
        return rock_from_json(answer.output);
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError("sets", std::string("the answer of the geometry helper is invalid: ") + error.what(),
                         "report this case");
    }
}

}  // namespace voussoir::importers::helper
