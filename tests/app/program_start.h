// The built program, started as its user starts it.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/test_files.h"

namespace voussoir::app
{

struct Ended {
    int exit_code = -1;  // -1: ended by a signal
    int signal = 0;      // that ended it
    std::string output, errors;
};

inline std::string contents(const std::filesystem::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Starts the program with its output in files of `folder`. @returns its process id
inline pid_t start(const TemporaryFolder& folder, const std::vector<std::string>& arguments)
{
    std::vector<std::string> words = arguments;
    words.insert(words.begin(), VOUSSOIR_PROGRAM);
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const std::string output = folder / "stdout", errors = folder / "stderr";
    const pid_t child = fork();
    if (child != 0) return child;
    dup2(open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    execv(pointers[0], pointers.data());
    _exit(127);
}

inline Ended finish(const TemporaryFolder& folder, pid_t child)
{
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, WIFSIGNALED(status) ? WTERMSIG(status) : 0,
            contents(folder / "stdout"), contents(folder / "stderr")};
}

inline Ended voussoir(const TemporaryFolder& folder, const std::vector<std::string>& arguments)
{
    return finish(folder, start(folder, arguments));
}

}  // namespace voussoir::app
