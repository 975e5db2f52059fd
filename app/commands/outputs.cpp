#include "app/commands/outputs.h"

#include <unistd.h>

#include <fstream>
#include <system_error>

#include "app/commands/say.h"
#include "app/results/atomic_file.h"
#include "libdda/errors.h"

namespace voussoir::app::commands
{
namespace
{

namespace fs = std::filesystem;

/// Can something be made in a folder that may itself have to be made?
bool can_be_made_in(fs::path folder)
{
    std::error_code error;
    folder = fs::absolute(folder, error);
    while (!fs::exists(folder, error) && folder.has_relative_path()) folder = folder.parent_path();
    return fs::is_directory(folder, error) && access(folder.c_str(), W_OK) == 0;
}

}  // namespace

void expect_writable(const std::optional<fs::path>& json, const std::optional<fs::path>& folder)
{
    if (json && *json != "-") {
        std::error_code none;
        const fs::path home = fs::absolute(*json, none).parent_path();
        if (!fs::is_directory(home, none) || fs::is_directory(*json, none) || !can_be_made_in(home))
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
    results::write_atomically(file, text);
}

void write_named_file(const fs::path& file, const std::string& text)
{
    std::error_code error;
    const fs::path place = fs::weakly_canonical(file, error);
    if (error) throw InputError(file.string(), error.message(), "name a file in a folder that exists");
    const fs::file_status there = fs::status(place, error);
    if (!fs::exists(there) || fs::is_regular_file(there)) return results::write_atomically(place, text);
    std::ofstream stream(place, std::ios::binary);  // a pipe or a device
    stream << text;
    stream.close();
    if (!stream) throw InputError(file.string(), "cannot be written", "name a file in a folder that exists");
}

void write_json_text(const fs::path& file, const std::string& text)
{
    if (file == "-") {
        put_json(text);
        return;
    }
    write_named_file(file, text + "\n");
}

}  // namespace voussoir::app::commands
