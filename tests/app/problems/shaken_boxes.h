// Two boxes on a floor that is shaken, for the tests of step problems.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "app/problems/problem_file.h"
#include "app/problems/take.h"
#include "libdda/errors.h"
#include "tests/app/test_files.h"

namespace voussoir::app::problems
{

/// Two boxes that slide to and fro on a floor that is shaken, and the folder in which their case lies.
class ShakenBoxes : public ::testing::Test
{
 protected:
    ShakenBoxes()
    {
        write("case.yaml",
              with(two_boxes, "{blocks: foundation}",
                   "{blocks: foundation, motion: {x: {sine: {acceleration: 8 m/s2, frequency: 10 Hz}}}}"));
        arguments.file = folder / "case.yaml";
    }
    void write(const std::string& name, const std::string& text) const
    {
        std::ofstream(folder / name, std::ios::binary) << text;
    }
    std::string bytes_of(const std::string& name) const
    {
        std::ostringstream text;
        text << std::ifstream(folder / name, std::ios::binary).rdbuf();
        return text.str();
    }
    /// The sentence with which a file of that name is refused.
    std::string refusal_of(const std::string& name) const
    {
        try {
            load(folder / name);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    TemporaryFolder folder;
    TakeArguments arguments;
};

}  // namespace voussoir::app::problems
