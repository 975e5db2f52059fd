#include "app/commands/outputs.h"

#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <system_error>

#include "libdda/errors.h"

namespace voussoir::app::commands
{
namespace
{

namespace fs = std::filesystem;

/// Can something be made in a folder that may itself have to be made?
bool can_be_made_in(fs::path folder)
{
    folder = fs::absolute(folder);
    std::error_code error;
    while (!fs::exists(folder, error) && folder.has_relative_path()) folder = folder.parent_path();
    return fs::is_directory(folder, error) && access(folder.c_str(), W_OK) == 0;
}

}  // namespace

void expect_writable(const std::optional<fs::path>& json, const std::optional<fs::path>& folder)
{
    if (json && *json != "-") {
        const fs::path home = fs::absolute(*json).parent_path();
        if (!fs::is_directory(home) || fs::is_directory(*json) || !can_be_made_in(home))
            throw InputError("--json " + json->string(), "cannot be written",
                             "name a file in a folder that exists");
    }
    if (folder && !can_be_made_in(*folder))
        throw InputError("-o " + folder->string(), "cannot be created or written",
                         "name a folder that can be created");
}

void make_output_folder(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw InputError("-o " + folder.string(), error.message(), "name a folder that can be created");
}

void write_own_file(const fs::path& file, const std::string& text)
{
    std::error_code none;
    fs::remove(file, none);  // a link there may lead anywhere
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream)
        throw InputError(file.string(), "cannot be written", "give a writable folder on a disk with free space");
}

void write_json_text(const fs::path& file, const std::string& text)
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

}  // namespace voussoir::app::commands
