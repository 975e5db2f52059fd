// Reading case texts in tests: what they become, and what is said about them.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "app/reader/case_file.h"
#include "libdda/errors.h"
#include "tests/app/test_files.h"

namespace voussoir::app::reader
{

inline Case read(const std::string& text, const std::vector<std::string>& overrides = {})
{
    const TemporaryFolder folder;
    return read_case(folder.write("case.yaml", text), overrides);
}

/// All faults of a text, one a line, without the folder's name.
inline std::string faults_of(const std::string& text, const std::vector<std::string>& overrides = {})
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.write("case.yaml", text);
    try {
        read_case(file, overrides);
    } catch (const InputError& error) {
        std::string all = error.what();
        const std::string prefix = file.parent_path().string() + "/";
        for (std::size_t at = all.find(prefix); at != std::string::npos; at = all.find(prefix))
            all.erase(at, prefix.size());
        return all;
    }
    return "no fault";
}

inline bool has_default(const Case& the_case, const std::string& part)
{
    return std::any_of(the_case.defaults.begin(), the_case.defaults.end(),
                       [&](const std::string& line) { return line.find(part) != std::string::npos; });
}

}  // namespace voussoir::app::reader
