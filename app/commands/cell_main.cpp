// voussoir-cell: one cell of the failure map, in a process of its own, so that a cell that crashes, hangs or eats
// memory is an outcome. Reads a request as JSON from its standard input, writes what the cell gave to its standard
// output.
#include <cmath>
#include <exception>
#include <iostream>
#include <iterator>

#include "app/reader/case_file.h"
#include "app/studies/stability/cell_wire.h"
#include "app/studies/stability/runner.h"
#include "importers/process/own_limits.h"
#include "importers/process/program_start.h"
#include "libdda/errors.h"

namespace
{

using namespace voussoir;

void limit(const app::studies::stability::CellRequest& request)
{
    importers::process::limit_self(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(request.budget)));
    importers::process::limit_own_memory(request.memory);
}

app::studies::stability::StabilityCell cell_named(const std::string& name)
{
    for (const app::studies::stability::StabilityScene& scene :
         app::studies::stability::stability_scenes(app::reader::case_reader))
        for (const app::studies::stability::StabilityCell& cell : scene.cells)
            if (cell.name == name) return cell;
    throw InputError("cell", name, "one that `voussoir stability --list` names");
}

}  // namespace

int main(int argc, char**)
{
    voussoir::importers::process::begin_helper();
    if (argc > 1) {
        std::fputs("voussoir-cell is started by voussoir: a request on the standard input\n", stderr);
        return 2;
    }
    try {
        const std::string text(std::istreambuf_iterator<char>(std::cin), {});
        const app::studies::stability::CellRequest request = app::studies::stability::cell_request_from_json(text);
        limit(request);
        std::cout << app::studies::stability::to_json(app::studies::stability::run_here(cell_named(request.name)));
        return 0;
    } catch (const std::exception& error) {
        voussoir::importers::process::complain("voussoir-cell", error.what());
        return 1;
    }
}
