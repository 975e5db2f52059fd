// voussoir-geometry: reads and certifies meshes on behalf of voussoir. A JSON request on the standard input, a
// JSON answer on the standard output. It limits its own memory and processor time: the files it reads are not
// trusted.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>
#include <string>

#include "importers/helper/import_meshes.h"
#include "importers/helper/rock.h"
#include "importers/helper/wire.h"
#include "importers/process/own_limits.h"
#include "importers/process/program_start.h"

namespace process = voussoir::importers::process;
namespace helper = voussoir::importers::helper;
namespace mesh = voussoir::importers::mesh;

namespace
{

void limit_resources(const helper::GeometryLimits& limits)
{
    process::limit_self(RLIMIT_CORE, 0);
    process::limit_self(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(std::clamp(limits.seconds, 1.0, 1e6))));
    process::limit_own_memory(limits.bytes);
}

std::string answer_to(const std::string& text)
{
    if (text == helper::formats_request()) return helper::to_json(mesh::mesh_formats());
    if (helper::asks_for_rock(text)) {
        limit_resources({});
        return helper::to_json(voussoir::importers::exact::cut_rock(helper::rock_request_from_json(text)));
    }
    const helper::HelperRequest request = helper::request_from_json(text);
    limit_resources(request.limits);
    return helper::to_json(helper::import_meshes(request.meshes));
}

}  // namespace

int main(int argc, char**)
{
    process::begin_helper();
    if (argc > 1) {
        std::fputs("voussoir-geometry is started by voussoir: a JSON request on the standard input\n", stderr);
        return 2;
    }
    try {
        const std::string text{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
        std::cout << answer_to(text) << std::flush;
        return std::cout ? 0 : 1;
    } catch (const std::exception& error) {
        voussoir::importers::process::complain("voussoir-geometry", error.what());
        return 1;
    }
}
