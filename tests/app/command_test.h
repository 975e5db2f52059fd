// The built program as its user types its commands, in a folder of its own.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/temporary_folder.h"

namespace voussoir::app
{

class CommandTest : public ::testing::Test
{
 protected:
    /// @param line what stands behind the program's name, for the shell. @param before a program to start it with.
    /// @returns the exit code; output and errors are in `output_`
    int voussoir(const std::string& line, const std::string& before = "")
    {
        const std::string home = folder_.path().string(), caught = home + ".out";
        const std::string command =
            "cd '" + home + "' && " + before + " '" VOUSSOIR_PROGRAM "' " + line + " > '" + caught + "' 2>&1";
        const int status = std::system(command.c_str());
        output_ = contents(caught);
        std::filesystem::remove(caught);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    /// @param file relative to the folder
    std::string contents(const std::filesystem::path& file) const
    {
        std::ostringstream text;
        text << std::ifstream(folder_.path() / file, std::ios::binary).rdbuf();
        return text.str();
    }

    TemporaryFolder folder_;
    std::string output_;
};

}  // namespace voussoir::app
