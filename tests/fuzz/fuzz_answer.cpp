// A libFuzzer target: any bytes, taken as the answer of the geometry helper. The helper reads files that are not
// trusted, so its answer is not trusted either: std::exception, or stones that hold.

#include <cstdint>
#include <exception>
#include <string>

#include "importers/helper/wire.h"
#include "tests/fuzz/accepted_geometry.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(reinterpret_cast<const char*>(data), size);
    voussoir::importers::helper::Geometry geometry;
    try {
        geometry = voussoir::importers::helper::geometry_from_json(text);
    } catch (const std::exception&) {
        return 0;
    }
    voussoir::check_accepted(geometry);
    return 0;
}
