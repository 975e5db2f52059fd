// voussoir-plot: diagrams. Reads the folder (a line) and the figures as JSON from its standard input, writes
// FOLDER/NAME.png for every figure, and the names to its standard output.
#include <exception>
#include <iostream>
#include <iterator>

#include "app/plots/draw_figure.h"
#include "app/plots/draw_map.h"
#include "importers/process/program_start.h"

namespace plots = voussoir::app::plots;

int main(int argc, char**)
{
    voussoir::importers::process::begin_helper();
    if (argc > 1) {
        std::fputs("voussoir-plot is started by voussoir: a request on the standard input\n", stderr);
        return 2;
    }
    try {
        std::string folder;
        std::getline(std::cin, folder);
        const std::string text(std::istreambuf_iterator<char>(std::cin), {});
        for (const plots::Figure& figure : plots::figures_of_json(text)) {
            const std::filesystem::path file = std::filesystem::path(folder) / (figure.name + ".png");
            figure.maps.empty() ? plots::draw_figure(figure, file) : plots::draw_map(figure, file);
            std::cout << figure.name << '\n';
        }
        return 0;
    } catch (const std::exception& error) {
        voussoir::importers::process::complain("voussoir-plot", error.what());
        return 2;
    }
}
