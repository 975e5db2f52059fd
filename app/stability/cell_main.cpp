// voussoir-cell: one cell of the failure map, in a process of its own, so that a cell that crashes, hangs or eats
// memory is an outcome. Reads a request as JSON from its standard input, writes what the cell gave to its standard
// output.
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>

#include "app/stability/cell_wire.h"
#include "app/stability/runner.h"
#include "libdda/errors.h"

namespace
{

using namespace voussoir;

void limit(const CellRequest& request)
{
    const auto seconds = static_cast<rlim_t>(std::ceil(request.budget));
    const rlimit time{seconds, seconds + 1}, memory{request.memory, request.memory};
    setrlimit(RLIMIT_CPU, &time);
    setrlimit(RLIMIT_AS, &memory);
}

StabilityCell cell_named(const std::string& name)
{
    for (const StabilityScene& scene : stability_scenes())
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
