// A helper does not outlive the program that asked it, however that ends, and leaves no half picture.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/app/program_start.h"

namespace voussoir::app
{
namespace
{

namespace fs = std::filesystem;
using std::chrono::milliseconds;

/// The processes whose parent is `parent`.
std::vector<pid_t> children_of(pid_t parent)
{
    std::vector<pid_t> children;
    for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
        const std::string name = entry.path().filename();
        if (name.find_first_not_of("0123456789") != std::string::npos) continue;
        const std::string stat = contents(entry.path() / "stat");
        const std::size_t end = stat.rfind(')');
        if (end == std::string::npos) continue;
        char state = 0;
        int of = 0;
        if (std::sscanf(stat.c_str() + end + 1, " %c %d", &state, &of) == 2 && of == parent && state != 'Z')
            children.push_back(std::stoi(name));
    }
    return children;
}

bool lives(pid_t process)
{
    const std::string stat = contents(fs::path("/proc") / std::to_string(process) / "stat");
    const std::size_t end = stat.rfind(')');
    return end != std::string::npos && stat.substr(end + 1, 2) != " Z";
}

template <typename Condition>
bool within(milliseconds time, const Condition& holds)
{
    for (const auto until = std::chrono::steady_clock::now() + time; std::chrono::steady_clock::now() < until;
         std::this_thread::sleep_for(milliseconds(2)))
        if (holds()) return true;
    return holds();
}

/// Starts the program, ends it with a signal when it has a helper, and waits for the helper's end.
/// @param pause between the helper's start and the signal
void expect_helper_ends(const TemporaryFolder& folder, const std::vector<std::string>& arguments, int signal,
                        milliseconds pause)
{
    const pid_t program = start(folder, arguments);
    std::vector<pid_t> helpers;
    const auto find = [&] { return !(helpers = children_of(program)).empty(); };
    bool has_helper = within(milliseconds(20000), find);
    std::this_thread::sleep_for(pause);
    if (pause.count() > 0) has_helper = within(milliseconds(5000), find);  // the first may have ended
    kill(program, signal);
    EXPECT_EQ(finish(folder, program).signal, signal);
    ASSERT_TRUE(has_helper);
    for (const pid_t helper : helpers) {
        EXPECT_TRUE(within(milliseconds(10000), [&] { return !lives(helper); }))
            << "a helper of " << arguments[0] << " lives on after signal " << signal;
        if (lives(helper)) kill(helper, SIGKILL);
    }
}

TEST(Helpers, OfAStudyEndWithIt)
{
    const TemporaryFolder folder;
    for (const int signal : {SIGTERM, SIGHUP, SIGKILL})
        expect_helper_ends(folder, {"stability", "sliding"}, signal, milliseconds(300));
    expect_helper_ends(folder, {"stability", "sliding"}, SIGKILL, milliseconds(0));
}

#ifdef VOUSSOIR_HAS_PICTURES
/// A picture whose last bytes are there.
bool is_whole_png(const fs::path& file)
{
    const std::string bytes = contents(file);
    return bytes.size() > 12 && bytes.compare(bytes.size() - 8, 4, "IEND") == 0;
}

TEST(Helpers, ThatDrawEndWithoutAHalfPicture)
{
    const TemporaryFolder folder;
    const fs::path file = folder.write("case.yaml", two_boxes);
    const std::string results = folder / "out";
    ASSERT_EQ(voussoir(folder, {"run", file.string(), "-q", "-o", results}).exit_code, 0);
    int pause = 0;
    for (const int signal : {SIGTERM, SIGHUP, SIGKILL, SIGTERM, SIGKILL}) {
        expect_helper_ends(folder,
                           {"render", results + "/results.h5", "-o", folder / "pictures", "--count", "12",
                            "--size", "1600", "1600"},
                           signal, milliseconds(pause));
        pause += 250;
        std::error_code none;  // killed before there was a folder
        for (const fs::directory_entry& entry : fs::directory_iterator(folder / "pictures", none))
            EXPECT_TRUE(entry.path().extension() == ".part" || is_whole_png(entry.path())) << entry.path();
    }
}
#endif

}  // namespace
}  // namespace voussoir::app
