#include "app/commands/json_output.h"

#include <cstdio>
#include <fstream>

#include "libdda/errors.h"

namespace voussoir
{

void write_json_text(const std::filesystem::path& file, const std::string& text)
{
    if (file == "-") {
        std::fputs((text + "\n").c_str(), stdout);
        return;
    }
    std::ofstream stream(file, std::ios::binary);
    stream << text << '\n';
    stream.close();
    if (!stream)
        throw InputError("--json " + file.string(), "cannot be written", "name a file in a folder that exists");
}

}  // namespace voussoir
