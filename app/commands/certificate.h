// The geometry certificate of a mesh file or of a case: what the stones are and how they stand together, as a
// table, as JSON, as a contact graph and as pictures.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "importers/assembly/assembly.h"
#include "importers/helper/geometry.h"
#include "libdda/model/model.h"

namespace voussoir::app::commands
{

/// Longer tables are cut short in print; the JSON has all rows.
constexpr std::size_t max_rows = 60;

/// A mesh file as `import` sees it: by itself.
struct CertifiedFile {
    importers::helper::ImportedMesh mesh;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // m, subtracted from all coordinates
    std::vector<importers::helper::Overlap> overlaps;
    importers::helper::JointFit fit;
    importers::assembly::Assembly assembly;  // of the accepted stones
};

/// A case as `check` sees it.
struct CertifiedCase {
    std::string file, title;
    std::vector<std::string> faults, warnings;  // no fault: the case can be run
    std::vector<importers::helper::ImportedMesh> meshes;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    double fit_tolerance = 0;  // m, as given or measured
    std::vector<importers::helper::Overlap> overlaps;
    importers::helper::JointFit fit;
    importers::assembly::Assembly assembly;
};

/// The accepted stones of meshes, overlaps among them, as an assembly.
/// @param also blocks that are none of them (boxes), and what is known of foundations; may be null
importers::assembly::Assembly assembly_of(const std::vector<importers::helper::ImportedMesh>& meshes,
                                          const std::vector<importers::helper::Overlap>& overlaps,
                                          const importers::assembly::AssemblyOrigin& origin,
                                          const Model* also = nullptr);

/// The blocks of a model. Outlines of a planar scene become prisms over its thickness.
/// @param volume_errors of blocks whose parts only approximate them, by name
importers::assembly::Assembly assembly_of(const Model& model, const std::map<std::string, double>& volume_errors,
                                          const importers::assembly::AssemblyOrigin& origin);

/// A list with one entry a file.
std::string certificates_json(const std::vector<CertifiedFile>& files);
std::string certificate_json(const CertifiedCase& the_case);

/// To standard output.
void print_contact_graph(const importers::assembly::Assembly& assembly);
void print_findings(const importers::assembly::Assembly& assembly);

/// `contact_graph.csv`: a line for each pair of stones that touch or stand apart by a gap.
/// @throws InputError when it cannot be written
void write_contact_graph(const importers::assembly::Assembly& assembly, const std::filesystem::path& file);

/// `assembly.png` and a picture of each defective stone, overlap, group of gaps, ... into a folder. Pictures of an
/// earlier certificate are removed. A warning to standard error when they cannot be drawn.
/// @returns whether all of them were drawn that a build of these options draws
bool draw_certificate(const std::string& title, const importers::assembly::Assembly& assembly,
                      const std::vector<importers::helper::ImportedMesh>& meshes,
                      const std::filesystem::path& folder);

}  // namespace voussoir::app::commands
