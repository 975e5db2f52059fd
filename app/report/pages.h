// What reports and comparisons share: how large displacements are drawn, pictures that may fail, files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/report/diagrams.h"
#include "app/report/document.h"
#include "app/report/run_record.h"

namespace voussoir::app::report
{

/// How much displacements are magnified so that the eye sees them: where the structure moves by less than a
/// thousandth of its size, so that it is about a fiftieth; a round number.
double visible_magnification(const RunRecord& record);

/// Draws, or says in the section why not: "what: the reason."
void attempt(Section& section, const char* what, const std::function<void()>& draw);

/// Draws the diagrams into a folder and puts each into its section; what cannot be drawn is told in the first one.
void add_diagrams(const std::vector<NamedFigure>& figures, const std::filesystem::path& folder,
                  std::vector<Section>& sections);

/// Those in which nothing stands.
void drop_empty_sections(Document& document);

/// folder/name, made if it is not there. @throws InputError
std::filesystem::path companions_folder(const std::filesystem::path& folder, const std::string& name);

/// Writes name.html, name.md and name.json into the folder, and the tables into folder/name.
/// @returns these three and the folder of companions
/// @throws InputError when something cannot be written
std::vector<std::filesystem::path> write_document(const Document& document, const std::filesystem::path& folder,
                                                  const std::string& name);

}  // namespace voussoir::app::report
