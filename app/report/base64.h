// Bytes as text.
#pragma once

#include <string>
#include <string_view>

namespace voussoir::app::report
{

/// Base64 with padding, as a page's data: addresses and atob() have it.
std::string base64(std::string_view bytes);

}  // namespace voussoir::app::report
