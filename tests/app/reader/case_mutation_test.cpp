// Case files damaged at random with a fixed seed: refused in words or read as sound cases, without more memory
// than a case deserves. scripts/fuzz does the same for hours.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>

#include "app/reader/case_file.h"
#include "libdda/errors.h"
#include "tests/app/test_files.h"
#include "tests/damage.h"
#include "tests/fuzz/accepted_case.h"
#include "tests/limited_requests.h"

namespace voussoir::app::reader
{

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t max_memory = 1U << 29U;  // bytes at once; 200 000 blocks take less

const fs::path seeds = fs::path(VOUSSOIR_CASES).parent_path() / "tests/fuzz/seeds";

/// Whether the case was accepted; what comes of it otherwise must be words.
bool accepts(const fs::path& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary) << text;
    std::string wrong;
    try {
        const LimitedRequests limit(max_memory);
        check_accepted(read_case(file, {}));
        return true;
    } catch (const InputError& error) {
        for (const Fault& fault : error.faults)
            if (fault.place.empty() || fault.found.empty() || fault.expected.empty()) wrong = error.what();
        if (error.faults.empty()) wrong = "refused without a word";
    } catch (const std::exception& error) {
        wrong = error.what();
    }
    EXPECT_EQ(wrong, "") << "the case was:\n" << text;
    return false;
}

}  // namespace

// Cases with meshes are left to the fuzzer: here every one of them would start the helper.
TEST(DamagedCases, AreRefusedInWordsOrReadAsSoundCases)
{
    const TemporaryFolder folder;
    for (const char* record : {"peer_npts.at2", "eqsig.txt"})
        fs::copy_file(seeds / "records" / record, folder.path() / record);
    Damage damage(1827);
    std::size_t accepted = 0, tried = 0;
    for (const fs::path& file : files_in(seeds / "case")) {
        const std::string sound = content_of(file);
        if (sound.find("mesh:") != std::string::npos) continue;
        SCOPED_TRACE(file.filename());
        EXPECT_TRUE(accepts(folder.path() / "case.yaml", sound)) << "the seed is worth damaging";
        for (int i = 0; i < 150 && !HasFailure(); ++i, ++tried)
            accepted += accepts(folder.path() / "case.yaml", damage(sound));
    }
    std::printf("%zu damaged cases, %zu of them still cases\n", tried, accepted);
    EXPECT_GT(accepted, tried / 50);
    EXPECT_LT(accepted, tried);
}

}  // namespace voussoir::app::reader
