// What bytes are before they are a record: encodings of texts, and contents that are no record, by name.
#pragma once

#include <string>
#include <string_view>

#include "libdda/errors.h"
#include "records/source_file.h"

namespace voussoir::records
{

/// A text in UTF-16 that begins with its byte order mark (Windows writes it), in UTF-8; any other bytes as they
/// are.
std::string decode_utf16(std::string bytes);

/// Whether a line holds a number with a decimal comma between blanks, semicolons or tabs: "0,01;-1,5".
bool has_decimal_commas(std::string_view line);

/// Why a file that no reader knows is no record: an archive, a page of the web, decimal commas, ...
/// @param formats names of those that are read
Fault why_unknown(const SourceFile& file, const std::string& formats);

}  // namespace voussoir::records
