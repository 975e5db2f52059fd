// Where nothing can be written, or nothing read, one clear sentence says so.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "app/results/results_reader.h"
#include "app/results/results_writer.h"
#include "libdda/errors.h"
#include "tests/app/results/synthetic.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::results
{
namespace
{

template <typename Action>
std::string sentence_of(Action action)
{
    try {
        action();
    } catch (const InputError& error) {
        EXPECT_EQ(error.faults.size(), 1U);
        return error.what();
    }
    return "nothing was refused";
}

/// No file may grow beyond `bytes` as long as this lives: a full disk for one process.
struct SmallDisk {
    explicit SmallDisk(rlim_t bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before);
        const rlimit small{bytes, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallDisk() { setrlimit(RLIMIT_FSIZE, &before); }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    rlimit before{};
};

TEST(Refusal, AFolderThatIsAFile)
{
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "taken") << "here";
    const Case the_case = synthetic::tower(Kinematics::spatial_rigid);
    const std::string sentence = sentence_of([&] { ResultsWriter(the_case, folder.path() / "taken"); });
    EXPECT_NE(sentence.find("cannot be written: Not a directory"), std::string::npos) << sentence;
}

TEST(Refusal, AFullDiskAtTheStart)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::tower(Kinematics::spatial_rigid);
    testing::internal::CaptureStderr();
    std::string sentence;
    {
        const SmallDisk disk(1000);
        sentence = sentence_of([&] { ResultsWriter(the_case, folder.path()); });
    }
    EXPECT_NE(sentence.find("File too large"), std::string::npos) << sentence;
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "HDF5 prints nothing";
}

TEST(Refusal, AFullDiskInTheMiddle)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(Kinematics::spatial_deformable);
    testing::internal::CaptureStderr();
    std::string sentence;
    {
        const SmallDisk disk(3'000'000);
        sentence = sentence_of([&] {
            ResultsWriter writer(the_case, folder.path());
            for (int i = 0; i < 10000; ++i) writer.frame(synthetic::swaying(the_case, 1e-3 * i), {});
        });
    }
    EXPECT_NE(sentence.find("results.h5"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("File too large"), std::string::npos) << sentence;
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Refusal, ResultsThatAreNone)
{
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "results.h5";
    EXPECT_NE(sentence_of([&] { ResultsReader{path}; }).find("No such file"), std::string::npos);
    std::ofstream(path) << "These are no results.";
    EXPECT_NE(sentence_of([&] { ResultsReader{path}; }).find("not a complete HDF5 file"), std::string::npos);
    Hdf5File::create(path).make_group("/other");
    EXPECT_NE(sentence_of([&] { ResultsReader{path}; }).find("no attribute format"), std::string::npos);
}

TEST(Refusal, AHistoryOfAnUnknownBlock)
{
    const TemporaryFolder folder;
    Case the_case = synthetic::tower(Kinematics::spatial_rigid);
    the_case.output.histories = {{"crown", "voussoir_47", {}}};
    const std::string sentence = sentence_of([&] { ResultsWriter(the_case, folder.path()); });
    EXPECT_NE(sentence.find("voussoir_47"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace voussoir::app::results
