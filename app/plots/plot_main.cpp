// voussoir-plot: diagrams. Reads the folder (a line) and the figures as JSON from its standard input, writes
// FOLDER/NAME.png for every figure, and the names to its standard output.
#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>

#include "app/plots/draw_figure.h"
#include "app/plots/draw_map.h"

int main()
{
    try {
        std::string folder;
        std::getline(std::cin, folder);
        const std::string text(std::istreambuf_iterator<char>(std::cin), {});
        for (const voussoir::app::plots::Figure& figure : voussoir::app::plots::figures_of_json(text)) {
            const std::filesystem::path file = std::filesystem::path(folder) / (figure.name + ".png");
            figure.maps.empty() ? voussoir::app::plots::draw_figure(figure, file)
                                : voussoir::app::plots::draw_map(figure, file);
            std::cout << figure.name << '\n';
        }
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "voussoir-plot: %s\n", error.what());
        return 2;
    }
}
