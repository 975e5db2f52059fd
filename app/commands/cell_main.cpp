// voussoir-cell: one cell of the failure map, in a process of its own, so that a cell that crashes, hangs or eats
// memory is an outcome. Reads a request as JSON from its standard input, writes what the cell gave to its standard
// output.
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>

#include "app/reader/case_file.h"
#include "app/studies/stability/cell_wire.h"
#include "app/studies/stability/runner.h"
#include "importers/process/own_limits.h"
#include "libdda/errors.h"

namespace
{

using namespace voussoir;

void limit(const CellRequest& request)
{
    limit_self(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(request.budget)));
    limit_own_memory(request.memory);
}

StabilityCell cell_named(const std::string& name)
{
    for (const StabilityScene& scene : stability_scenes(case_reader))
        for (const StabilityCell& cell : scene.cells)
            if (cell.name == name) return cell;
    throw InputError("cell", name, "one that `voussoir stability --list` names");
}

}  // namespace

int main()
{
    try {
        const std::string text(std::istreambuf_iterator<char>(std::cin), {});
        const CellRequest request = cell_request_from_json(text);
        limit(request);
        std::cout << to_json(run_here(cell_named(request.name)));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "voussoir-cell: %s\n", error.what());
        return 1;
    }
}
