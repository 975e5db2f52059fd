// voussoir-generate-record as its user meets it.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/records/test_files.h"

namespace voussoir::records
{
namespace
{

/// The command in the second line of a shipped record, run by the program that wrote it, makes the same bytes.
TEST(ShippedRecords, AreMadeAgainByteForByte)
{
    for (const std::string component : {"x", "y", "z"}) {
        const std::string name = "synthetic_" + component + ".at2";
        const std::string shipped = read_text(repository() / "cases" / "records" / name);
        const std::size_t start = shipped.find("voussoir-generate-record "), end = shipped.find(" -o " + name);
        ASSERT_TRUE(start != std::string::npos && end != std::string::npos && start < end);
        const std::string arguments = shipped.substr(start + 25, end - start - 25);
        const TemporaryFile again("", name);
        const std::string command = std::string("\"") + VOUSSOIR_GENERATE_RECORD + "\" " + arguments + " -o \"" +
                                    again.path().string() + "\"";
        ASSERT_EQ(std::system(command.c_str()), 0) << command;
        // The header repeats the name of the file, which here carries a prefix.
        std::string made = read_text(again.path());
        const std::string written_name = again.path().filename().string();
        const std::size_t at = made.find(written_name);
        ASSERT_NE(at, std::string::npos);
        made.replace(at, written_name.size(), name);
        EXPECT_TRUE(made == shipped) << name << " differs from what its command makes";
    }
}

struct Answer {
    int exit_code = -1;
    std::string text;  // what it printed, errors too
};

Answer generate(const std::string& arguments)
{
    const TemporaryFile printed("", "printed");
    const std::string command = std::string("\"") + VOUSSOIR_GENERATE_RECORD + "\" " + arguments + " > \"" +
                                printed.path().string() + "\" 2>&1";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(printed.path())};
}

TEST(GenerateRecord, RefusesBadOptionsInASentenceAndWritesNothing)
{
    const std::string file = ::testing::TempDir() + "not_written.at2", output = " -o \"" + file + "\"";
    const std::pair<std::string, std::string> refused[] = {
        {"", "--output is required"},
        {"--pga much" + output, "much is not a number"},
        {"--pga -1" + output, "peak acceleration"},
        {"--seed 1.5" + output, "1.5 is not a whole number from 0 to 2^53"},
        {"--seed -1" + output, "-1 is not a whole number from 0 to 2^53"},
        {"--colour red" + output, "--colour"},
        {"something" + output, "something"},
        {"-o /nowhere/a.at2", "cannot be written"}};
    for (const auto& [arguments, words] : refused) {
        const Answer answer = generate(arguments);
        EXPECT_EQ(answer.exit_code, 2) << arguments;
        EXPECT_NE(answer.text.find(words), std::string::npos) << arguments << ": " << answer.text;
        EXPECT_FALSE(std::filesystem::exists(file)) << arguments;
    }
}

TEST(GenerateRecord, NamesItsOptionsAndTheirDefaults)
{
    const Answer help = generate("--help");
    EXPECT_EQ(help.exit_code, 0);
    for (const char* words :
         {"--time-step NUMBER=0.005", "--pga NUMBER=0.3", "--seed NUMBER=1", "--component NAME=X"})
        EXPECT_NE(help.text.find(words), std::string::npos) << words << " is not in " << help.text;
}

}  // namespace
}  // namespace voussoir::records
