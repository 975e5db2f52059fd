// Text inside XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace voussoir::app::words
{

/// The text as content or quoted attribute of XML or HTML: `&`, `<`, `>` and quotes as entities; control
/// characters, which XML does not allow, as blanks, line ends and tabs as they are.
std::string xml_text(std::string_view text);

}  // namespace voussoir::app::words
