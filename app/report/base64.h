// Bytes as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace voussoir::app::report
{

/// Base64 with padding, as a page's data: addresses and atob() have it.
std::string base64(std::string_view bytes);

/// Numbers as the script's typed arrays have them; every machine that this program runs on is little-endian.
template <typename T>
std::string packed(const std::vector<T>& values)
{
    return base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

}  // namespace voussoir::app::report
