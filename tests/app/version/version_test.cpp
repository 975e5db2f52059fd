// What the program says it was built from, and how that is found out at each build.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/version/version.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::version
{
namespace
{

namespace fs = std::filesystem;

std::string contents(const fs::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

TEST(EngineVersion, IsToldInWords)
{
    EngineVersion engine{"0.2.0", "8951b6b97059", Dirty::no, "0123456789ab", {"x86-64", "g++ 1", "3.4.0"}};
    const std::string rest = ", sources 0123456789ab, x86-64, g++ 1, Eigen 3.4.0";
    EXPECT_EQ(in_words(engine), "0.2.0, commit 8951b6b97059" + rest);
    engine.dirty = Dirty::yes;
    EXPECT_EQ(in_words(engine), "0.2.0, commit 8951b6b97059 with changes" + rest);
    engine.dirty = Dirty::unknown;
    EXPECT_EQ(in_words(engine), "0.2.0, commit 8951b6b97059, changes not known" + rest);
    engine.commit.clear();
    EXPECT_EQ(in_words(engine), "0.2.0, commit not known" + rest);
}

TEST(EngineVersion, IsThatOfTheProject)
{
    const EngineVersion engine = engine_version();
    EXPECT_EQ(engine.version, VOUSSOIR_PROJECT_VERSION);
    EXPECT_EQ(engine.sources.size(), 12U);
    EXPECT_EQ(engine.compilation, compilation());
    const auto json = nlohmann::json::parse(engine_json("0123456789ab"));
    EXPECT_EQ(json.at("version"), engine.version);
    EXPECT_EQ(json.at("commit").is_null(), engine.commit.empty());
    EXPECT_EQ(json.at("dirty").is_null(), engine.dirty == Dirty::unknown);
    EXPECT_EQ(json.at("sources"), engine.sources);
    EXPECT_EQ(json.at("behaviour"), "0123456789ab");
    EXPECT_FALSE(nlohmann::json::parse(engine_json()).contains("behaviour"));
    EXPECT_NE(engine_paragraph("0123456789ab").find("behaviour 0123456789ab"), std::string::npos);
}

/// A little checkout with one source of the engine and the script that finds its version.
class VersionScript : public ::testing::Test
{
 protected:
    VersionScript()
    {
        fs::create_directories(root() / "libdda");
        fs::create_directories(root() / "app");
        fs::copy(VOUSSOIR_VERSION_FOLDER, root() / "app/version");
        folder_.write("root/libdda/step.cpp", "int step();\n");
    }
    fs::path root() const { return folder_ / "root"; }
    fs::path script() const { return root() / "app/version/write_version.cmake"; }
    fs::path output() const { return folder_ / "built_from.cpp"; }
    int run(const std::string& command) const
    {
        return std::system((command + " >'" + (folder_ / "log").string() + "' 2>&1").c_str());
    }
    int git(const std::string& command) const
    {
        return run("git -c user.name=test -c user.email=test@example.org -C '" + root().string() + "' " + command);
    }
    /// @returns "commit, Dirty, sources" as written
    std::vector<std::string> built_from() const
    {
        EXPECT_EQ(run("'" VOUSSOIR_CMAKE "' '-DROOT=" + root().string() + "' -DVERSION=1.2.3 '-DOUTPUT=" +
                      output().string() + "' -DGIT=git -P '" + script().string() + "'"),
                  0)
            << contents(folder_ / "log");
        const std::string text = contents(output()), before = "return {\"1.2.3\", \"";
        std::vector<std::string> found;
        std::size_t from = text.find(before) + before.size(), to = text.find('"', from);
        found.push_back(text.substr(from, to - from));
        from = text.find("Dirty::", to) + 7;
        found.push_back(text.substr(from, text.find(',', from) - from));
        from = text.find('"', from) + 1;
        found.push_back(text.substr(from, text.find('"', from) - from));
        return found;
    }
    std::string head() const
    {
        EXPECT_EQ(git("rev-parse HEAD"), 0);
        return contents(folder_ / "log").substr(0, 12);
    }
    TemporaryFolder folder_;
};

TEST_F(VersionScript, KnowsNoCommitOutsideACheckout)
{
    EXPECT_EQ(built_from()[0], "");
    EXPECT_EQ(built_from()[1], "unknown");
    EXPECT_EQ(built_from()[2].size(), 12U);
}

TEST_F(VersionScript, SeesCommitsAndChanges)
{
    if (run("git --version") != 0) GTEST_SKIP() << "git is not installed";
    ASSERT_EQ(git("init -q"), 0);
    EXPECT_EQ(built_from()[0], "") << "nothing is committed yet";
    ASSERT_EQ(git("add -A"), 0);
    ASSERT_EQ(git("commit -q -m first"), 0) << contents(folder_ / "log");
    const auto first = built_from();
    EXPECT_EQ(first[0], head());
    EXPECT_EQ(first[1], "no");

    folder_.write("root/libdda/step.cpp", "int step(int);\n");
    const auto changed = built_from();
    EXPECT_EQ(changed[0], first[0]);
    EXPECT_EQ(changed[1], "yes");
    EXPECT_NE(changed[2], first[2]);

    ASSERT_EQ(git("commit -q -a -m second"), 0);
    const auto second = built_from();
    EXPECT_EQ(second[0], head());
    EXPECT_NE(second[0], first[0]);
    EXPECT_EQ(second[1], "no");
    EXPECT_EQ(second[2], changed[2]);

    // A document is no source of numbers, and files that git does not know are not its business.
    folder_.write("root/notes.md", "notes\n");
    EXPECT_EQ(built_from(), second);
}

TEST_F(VersionScript, LeavesTheFileAloneWhereNothingChanged)
{
    built_from();
    const auto written = fs::last_write_time(output()) - std::chrono::hours(1);
    fs::last_write_time(output(), written);
    built_from();
    EXPECT_EQ(fs::last_write_time(output()), written);
    folder_.write("root/libdda/step.cpp", "int step(int);\n");
    built_from();
    EXPECT_NE(fs::last_write_time(output()), written);
}

TEST_F(VersionScript, TakesNoCommitOfTheCheckoutAroundIt)
{
    if (run("git --version") != 0) GTEST_SKIP() << "git is not installed";
    ASSERT_EQ(run("git init -q '" + folder_.path().string() + "'"), 0);
    ASSERT_EQ(git("add -A"), 0);
    ASSERT_EQ(git("commit -q -m other"), 0);
    EXPECT_EQ(built_from()[0], "");
}

TEST_F(VersionScript, KnowsTheCommitOfAnArchive)
{
    if (run("git --version") != 0) GTEST_SKIP() << "git is not installed";
    ASSERT_EQ(git("init -q"), 0);
    ASSERT_EQ(git("add -A"), 0);
    ASSERT_EQ(git("commit -q -m first"), 0);
    const auto checkout = built_from();
    ASSERT_EQ(git("archive -o ../archive.tar HEAD"), 0);
    fs::remove_all(root());
    fs::create_directory(root());
    ASSERT_EQ(run("tar -xf '" + (folder_ / "archive.tar").string() + "' -C '" + root().string() + "'"), 0);
    const auto archive = built_from();
    EXPECT_EQ(archive[0], checkout[0]);
    EXPECT_EQ(archive[1], "unknown");
    EXPECT_EQ(archive[2], checkout[2]);
}

}  // namespace
}  // namespace voussoir::app::version
