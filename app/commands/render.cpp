#include <fmt/core.h>

#include "app/commands/commands.h"
#include "app/render/snapshots.h"
#include "libdda/errors.h"

namespace voussoir::app::commands
{

int render_command(const RenderArguments& arguments)
{
    if (!std::filesystem::is_regular_file(arguments.results))
        throw InputError(arguments.results.string(), "no such file", "give the results.h5 of a run");
    SnapshotOptions options;
    options.color =
        arguments.color == "principal_stress" ? SnapshotColor::principal_stress : SnapshotColor::displacement;
    options.times = arguments.times;
    options.count = arguments.count;
    options.width = arguments.size.at(0);
    options.height = arguments.size.at(1);
    options.deformation_scale = arguments.deformation_scale;
    const std::filesystem::path folder =
        arguments.folder.empty() ? arguments.results.parent_path() / "snapshots" : arguments.folder;
    for (const std::filesystem::path& picture : render::render_snapshots(arguments.results, folder, options))
        fmt::print("{}\n", picture.string());
    return exit_done;
}

}  // namespace voussoir::app::commands
