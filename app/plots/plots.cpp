#include "app/plots/plots.h"

#include "app/words/lines.h"
#include "importers/process/child_process.h"
#include "libdda/errors.h"

namespace voussoir::app::plots
{
namespace
{

std::filesystem::path helper()
{
    return importers::process::helper_folder() / "voussoir-plot";
}

}  // namespace

bool can_draw_figures()
{
    return std::filesystem::exists(helper());
}

std::vector<std::string> draw_figures(const std::vector<Figure>& figures, const std::filesystem::path& folder)
{
    constexpr double seconds_allowed = 120;
    constexpr std::size_t max_output = std::size_t{1} << 20;  // bytes, a list of names
    if (!can_draw_figures()) {
        throw InputError(helper().string(), "there is no such program",
                         "build voussoir with VOUSSOIR_RENDER=ON, or ask for no diagrams");
    }
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw InputError(folder.string(), error.message(), "name a folder that can be created");
    const std::string request = std::filesystem::absolute(folder).string() + "\n" + figures_json(figures);
    const importers::process::ChildAnswer answer =
        importers::process::ask_child(helper(), request, seconds_allowed, max_output);
    if (!answer.failure.empty())
        throw InputError(folder.string(), "voussoir-plot drew no diagrams: " + answer.failure, "see its message");
    return words::lines_of(answer.output);
}

}  // namespace voussoir::app::plots
