// Short files of every format, damaged at random with a fixed seed: a reader refuses in words or reads what holds
// of every record, and never asks for more memory than the file deserves. scripts/fuzz does the same for hours.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "libdda/errors.h"
#include "records/record.h"
#include "tests/damage.h"
#include "tests/fuzz/accepted_record.h"
#include "tests/limited_requests.h"
#include "tests/records/test_files.h"

namespace voussoir::records
{

namespace
{

constexpr std::size_t max_memory = 20'000'000;  // bytes; the files have less than 10 kB

std::vector<std::filesystem::path> seeds()
{
    return files_in(repository() / "tests/fuzz/seeds/records");
}

ReadOptions any_options(Damage& damage)
{
    ReadOptions options;
    if (damage.below(2) > 0) options.unit = "g";
    if (damage.below(3) == 0) options.time_step = 0.01;
    if (damage.below(6) == 0) options.column = static_cast<int>(damage.below(4));
    return options;
}

/// Whether the file was accepted; what comes of it otherwise must be words.
bool accepts(const std::string& content, const ReadOptions& options)
{
    bool accepted = false;
    std::string wrong;
    try {
        const LimitedRequests limit(max_memory);
        check_accepted(parse_record("damaged", content, options));
        accepted = true;
    } catch (const InputError& error) {
        if (error.faults.empty()) wrong = "refused without a word";
    } catch (const std::exception& error) {
        wrong = error.what();
    }
    EXPECT_EQ(wrong, "") << "the file was:\n" << content;
    return accepted;
}

}  // namespace

TEST(DamagedRecords, AreRefusedInWordsOrReadAsSoundRecords)
{
    Damage damage(2009);
    const std::vector<std::filesystem::path> files = seeds();
    ASSERT_GE(files.size(), 8);
    std::size_t accepted = 0, tried = 0;
    for (const std::filesystem::path& file : files) {
        SCOPED_TRACE(file.filename());
        const std::string sound = read_text(file);
        ASSERT_LT(sound.size(), 10'000);
        for (int i = 0; i < 400 && !HasFailure(); ++i, ++tried)
            accepted += accepts(damage(sound), any_options(damage));
    }
    std::printf("%zu damaged files of %zu, %zu of them still records\n", tried, files.size(), accepted);
    EXPECT_GT(accepted, tried / 50);
    EXPECT_LT(accepted, tried);
}

// The seeds are worth damaging: each is a record as it stands, or with what a user adds.
TEST(DamagedRecords, ComeFromSoundOnes)
{
    for (const std::filesystem::path& file : seeds()) {
        if (file.filename() == "decimal_commas.csv") continue;  // looks like one and is none
        const std::string sound = read_text(file);
        const bool good = accepts(sound, {}) || accepts(sound, {.unit = "g"}) ||
                          accepts(sound, {.unit = "g", .time_step = 0.01});
        EXPECT_TRUE(good) << file.filename();
    }
}

}  // namespace voussoir::records
