// voussoir-defects: draws pictures of stones with what is wrong with them marked, on behalf of voussoir. A JSON
// request on the standard input; the files it made, one to a line, on the standard output.
#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>
#include <string>

#include "app/render/defect_page.h"
#include "importers/process/program_start.h"
#include "libdda/errors.h"

namespace render = voussoir::app::render;

int main(int argc, char**)
{
    voussoir::importers::process::begin_helper();
    if (argc > 1) {
        std::fputs("voussoir-defects is started by voussoir: a JSON request on the standard input\n", stderr);
        return 2;
    }
    try {
        const std::string text{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
        const render::DefectRequest request = render::defects_from_json(text);
        for (const std::filesystem::path& file : render::draw_defect_pages(request.pictures, request.folder))
            std::cout << file.string() << '\n';
        std::cout.flush();
        return std::cout ? 0 : 1;
    } catch (const std::exception& error) {
        voussoir::importers::process::complain("voussoir-defects", error.what());
        return 1;
    }
}
