// What command lines and case files call colours and films.
#pragma once

#include <string>
#include <vector>

#include "app/case/case.h"

namespace voussoir::app::render
{

/// In the order of SnapshotColor.
std::vector<std::string> color_names();
const char* name_of(SnapshotColor color);
/// @throws InputError for another name
SnapshotColor color_named(const std::string& name);

/// In the order of FilmFormat, as files end.
std::vector<std::string> film_format_names();
const char* name_of(FilmFormat format);
/// @throws InputError for another name
FilmFormat film_format_named(const std::string& name);

}  // namespace voussoir::app::render
