#include <nlohmann/json.hpp>

#include "app/commands/certificate.h"
#include "importers/helper/repair_summary.h"

namespace voussoir::app::commands
{
namespace
{

using nlohmann::json;

json names_of(const importers::assembly::Assembly& assembly, const std::vector<int>& stones)
{
    json names = json::array();
    for (const int stone : stones) names.push_back(assembly.stones[stone].name);
    return names;
}

const char* name_of(importers::assembly::Touch touch)
{
    switch (touch) {
        case importers::assembly::Touch::face:
            return "face";
        case importers::assembly::Touch::tilted:
            return "tilted";
        case importers::assembly::Touch::corner:
            return "corner";
        case importers::assembly::Touch::edge:
            break;
    }
    return "edge";
}

template <typename Pair>
json pair_of(const importers::assembly::Assembly& assembly, const Pair& pair)
{
    return {{"a", assembly.stones[pair.a].name}, {"b", assembly.stones[pair.b].name}};
}

json contacts_of(const importers::assembly::Assembly& assembly)
{
    json contacts = json::array();
    for (const importers::assembly::StoneContact& contact : assembly.contacts) {
        contacts.push_back(pair_of(assembly, contact));
        contacts.back().update({{"area_m2", contact.area},
                                {"gap_m", contact.smallest_gap},
                                {"largest_gap_m", contact.largest_gap},
                                {"facing_area_m2", contact.facing_area},
                                {"patches", contact.patches},
                                {"touch", name_of(contact.touch)},
                                {"normal", {contact.normal.x(), contact.normal.y(), contact.normal.z()}}});
    }
    return contacts;
}

json gaps_of(const importers::assembly::Assembly& assembly)
{
    json gaps = json::array();
    for (const importers::assembly::StoneGap& gap : assembly.gaps) {
        gaps.push_back(pair_of(assembly, gap));
        gaps.back().update({{"gap_m", gap.width}, {"widest_m", gap.widest}, {"area_m2", gap.area}});
    }
    return gaps;
}

json overlaps_of(const importers::assembly::Assembly& assembly)
{
    json overlaps = json::array();
    for (const importers::assembly::StoneOverlap& overlap : assembly.overlaps) {
        overlaps.push_back(pair_of(assembly, overlap));
        overlaps.back().update({{"volume_m3", overlap.volume}, {"depth_m", overlap.depth}});
    }
    return overlaps;
}

json slivers_of(const importers::assembly::Assembly& assembly)
{
    json slivers = json::array();
    for (const importers::assembly::SliverStone& sliver : assembly.slivers)
        slivers.push_back({{"stone", assembly.stones[sliver.stone].name},
                           {"width_m", sliver.width},
                           {"diameter_m", sliver.diameter},
                           {"shortest_edge_m", sliver.shortest_edge},
                           {"thin", sliver.thin}});
    return slivers;
}

json size_ratio_of(const importers::assembly::Assembly& assembly)
{
    if (assembly.largest < 0) return {};
    return {{"ratio", assembly.size_ratio},
            {"largest", assembly.stones[assembly.largest].name},
            {"smallest", assembly.stones[assembly.smallest].name}};
}

json to_json(const importers::assembly::Assembly& assembly)
{
    json components = json::array(), findings = json::array(), advice = json::array();
    for (const std::vector<int>& component : assembly.components)
        components.push_back(names_of(assembly, component));
    for (const importers::assembly::AssemblyFinding& finding : assembly.findings) {
        findings.push_back({{"kind", finding.kind},
                            {"found", finding.what},
                            {"advice", finding.advice},
                            {"harmless", finding.harmless},
                            {"stones", names_of(assembly, finding.stones)}});
        advice.push_back(finding.what + ": " + finding.advice);
    }
    return {{"contacts", contacts_of(assembly)},
            {"contact_tolerance", importers::assembly::assembly_tolerance::contact},
            {"components", std::move(components)},
            {"ground", names_of(assembly, assembly.ground)},
            {"ground_from", assembly.ground_given ? "foundations" : "lowest level"},
            {"floating", names_of(assembly, assembly.floating)},
            {"unsupported", names_of(assembly, assembly.unsupported)},
            {"gaps", gaps_of(assembly)},
            {"overlaps", overlaps_of(assembly)},
            {"slivers", slivers_of(assembly)},
            {"size_ratio", size_ratio_of(assembly)},
            {"findings", std::move(findings)},
            {"advice", std::move(advice)}};
}

json sentences_of(const std::vector<importers::mesh::Repair>& repairs)
{
    json sentences = json::array();
    for (const importers::mesh::Repair& repair : repairs) sentences.push_back(repair.text);
    return sentences;
}

json kinds_of_repairs(const importers::helper::ImportedMesh& mesh)
{
    json kinds = json::array();
    for (const importers::helper::RepairSummary& kind : importers::helper::summarised_repairs(mesh))
        kinds.push_back({{"kind", kind.kind},
                         {"stones", kind.stones},
                         {"count", kind.count},
                         {"counted", kind.counted},
                         {"worst", kind.worst},
                         {"unit", kind.unit},
                         {"worst_stone", kind.worst_stone},
                         {"summary", importers::helper::in_words(kind)}});
    return kinds;
}

json skipped_of(const importers::helper::ImportedMesh& mesh)
{
    json skipped = json::array();
    for (const importers::helper::SkippedStone& stone : mesh.skipped)
        skipped.push_back({{"name", stone.name}, {"why", stone.why}});
    return skipped;
}

json to_json(const importers::helper::Stone& stone, const importers::helper::ImportedMesh& mesh,
             const Eigen::Vector3d& origin)
{
    const Eigen::Vector3d centroid = stone.moments.centroid + origin;
    const double cube = mesh.metres_per_unit * mesh.metres_per_unit * mesh.metres_per_unit;
    const bool measured = stone.moments.volume > 0;
    json features = json::array();
    for (const importers::mesh::MarkedFeature& feature : stone.features) features.push_back(feature.label);
    return {{"name", stone.name},
            {"closed", stone.closed},
            {"convex", stone.convex},
            {"parts", stone.parts.size()},
            {"volume_file_units", measured ? json(stone.moments.volume / cube) : json()},
            {"volume_m3", measured ? json(stone.moments.volume) : json()},
            {"volume_error", stone.volume_error},
            {"fit_move_m", stone.fit_move},
            {"fit_volume_change", stone.fit_volume_change},
            {"centroid_m", measured ? json({centroid.x(), centroid.y(), centroid.z()}) : json()},
            {"repairs", sentences_of(stone.repairs)},
            {"features", std::move(features)},
            {"reason", stone.reason},
            {"cure", stone.cure}};
}

json to_json(const std::vector<importers::helper::Overlap>& overlaps)
{
    json list = json::array();
    for (const importers::helper::Overlap& overlap : overlaps)
        list.push_back({{"stones", {overlap.stone_a, overlap.stone_b}}, {"volume_m3", overlap.volume}});
    return list;
}

json to_json(const importers::helper::JointFit& fit)
{
    return {{"joints", fit.joints},
            {"left", fit.left},
            {"misfit_before_m", fit.misfit_before},
            {"misfit_after_m", fit.misfit_after}};
}

json stones_of(const importers::helper::ImportedMesh& mesh, const Eigen::Vector3d& origin)
{
    json stones = json::array();
    for (const importers::helper::Stone& stone : mesh.stones) stones.push_back(to_json(stone, mesh, origin));
    return stones;
}

/// Names that are not UTF-8 get replacement characters; nothing else can fail.
std::string dump(const json& value)
{
    return value.dump(2, ' ', false, json::error_handler_t::replace);
}

}  // namespace

std::string certificates_json(const std::vector<CertifiedFile>& files)
{
    json list = json::array();
    for (const CertifiedFile& file : files)
        list.push_back({{"file", file.mesh.file},
                        {"accepted", file.mesh.accepted},
                        {"reason", file.mesh.reason},
                        {"repairs", sentences_of(file.mesh.repairs)},
                        {"repair_kinds", kinds_of_repairs(file.mesh)},
                        {"skipped", skipped_of(file.mesh)},
                        {"unit", {{"metres", file.mesh.metres_per_unit}, {"from", file.mesh.unit_from}}},
                        {"origin_m", {file.origin.x(), file.origin.y(), file.origin.z()}},
                        {"overlaps", to_json(file.overlaps)},
                        {"fit_joints", to_json(file.fit)},
                        {"stones", stones_of(file.mesh, file.origin)},
                        {"assembly", to_json(file.assembly)}});
    return dump(list);
}

std::string certificate_json(const CertifiedCase& the_case)
{
    json meshes = json::array(), blocks = json::array();
    for (const importers::helper::ImportedMesh& mesh : the_case.meshes)
        meshes.push_back({{"file", mesh.file},
                          {"accepted", mesh.accepted},
                          {"reason", mesh.reason},
                          {"repairs", sentences_of(mesh.repairs)},
                          {"repair_kinds", kinds_of_repairs(mesh)},
                          {"skipped", skipped_of(mesh)},
                          {"unit", {{"metres", mesh.metres_per_unit}, {"from", mesh.unit_from}}},
                          {"stones", stones_of(mesh, the_case.origin)}});
    for (const importers::assembly::AssemblyStone& stone : the_case.assembly.stones)
        blocks.push_back({{"name", stone.name},
                          {"parts", stone.parts.size()},
                          {"volume_m3", stone.volume},
                          {"volume_error", stone.volume_error},
                          {"foundation", stone.foundation}});
    return dump({{"case", the_case.file},
                 {"title", the_case.title},
                 {"accepted", the_case.faults.empty()},
                 {"faults", the_case.faults},
                 {"warnings", the_case.warnings},
                 {"origin_m", {the_case.origin.x(), the_case.origin.y(), the_case.origin.z()}},
                 {"fit_joints", to_json(the_case.fit)},
                 {"fit_tolerance_m", the_case.fit_tolerance},
                 {"overlaps", to_json(the_case.overlaps)},
                 {"files", std::move(meshes)},
                 {"blocks", std::move(blocks)},
                 {"assembly", to_json(the_case.assembly)}});
}

}  // namespace voussoir::app::commands
