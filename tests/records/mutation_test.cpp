// Short files of every format, damaged at random with a fixed seed: a reader refuses in words or reads what holds
// of every record, and never asks for more memory than the file deserves. scripts/fuzz does the same for hours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <random>
#include <string>
#include <vector>

#include "libdda/errors.h"
#include "records/record.h"
#include "tests/fuzz/accepted_record.h"
#include "tests/records/test_files.h"

namespace
{

constexpr std::size_t largest_request = 20'000'000;  // bytes; the files have less than 10 kB
bool requests_are_limited = false;

}  // namespace

// Any single request beyond the bound fails, and the test with it.
void* operator new(std::size_t size)
{
    if (requests_are_limited && size > largest_request) throw std::bad_alloc();
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}

namespace voussoir
{

namespace
{

/// Damages texts and bytes. The same on every machine: the standard distributions are not.
class Damage
{
 public:
    explicit Damage(unsigned seed) : engine_(seed) {}

    std::string operator()(std::string content)
    {
        for (std::size_t times = 1 + below(3); times > 0; --times) damage(content);
        return content;
    }

    std::size_t below(std::size_t bound) { return bound == 0 ? 0 : engine_() % bound; }

 private:
    void damage(std::string& content)
    {
        switch (below(8)) {
            case 0:
                return flip(content);
            case 1:
                return content.resize(below(content.size() + 1));
            case 2:
                return repeat(content);
            case 3:
            case 4:
            case 5:
                return replace_number(content);
            case 6:
                return drop_line(content);
            default:
                return swap_lines(content);
        }
    }

    void flip(std::string& content)
    {
        if (!content.empty()) content[below(content.size())] ^= static_cast<char>(1U << below(8));
    }

    void repeat(std::string& content)
    {
        const std::size_t from = below(content.size());
        content.insert(below(content.size()), content.substr(from, 1 + below(200)));
    }

    void replace_number(std::string& content)
    {
        static const char* const bad[] = {"nan",         "inf", "1e308",       "-1",     "0",     "99999999999",
                                          "-2147483649", "",    "0.000000001", "1e-320", "1e999", "2147483647"};
        static const char* const digits = "0123456789";
        const std::size_t at = content.find_first_of(digits, below(content.size()));
        if (at == std::string::npos) return;
        const std::size_t end = content.find_first_not_of("0123456789.eE", at);
        content.replace(at, std::min(end, content.size()) - at, bad[below(std::size(bad))]);
    }

    /// Start and length, its end included, of a line taken at random.
    std::pair<std::size_t, std::size_t> any_line(const std::string& content)
    {
        const std::size_t inside = below(content.size());
        const std::size_t before = inside == 0 ? std::string::npos : content.rfind('\n', inside - 1);
        const std::size_t start = before == std::string::npos ? 0 : before + 1;
        const std::size_t end = std::min(content.find('\n', start), content.size());
        return {start, std::min(end + 1, content.size()) - start};
    }

    void drop_line(std::string& content)
    {
        const auto [start, length] = any_line(content);
        content.erase(start, length);
    }

    void swap_lines(std::string& content)
    {
        const auto [start, length] = any_line(content);
        const std::string line = content.substr(start, length);
        content.erase(start, length);
        content.insert(any_line(content).first, line);
    }

    std::mt19937 engine_;
};

std::vector<std::filesystem::path> seeds()
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(repository() / "tests/fuzz/seeds/records"))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
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
    requests_are_limited = true;
    bool accepted = false;
    std::string wrong;
    try {
        check_accepted(parse_record("damaged", content, options));
        accepted = true;
    } catch (const InputError& error) {
        if (error.faults.empty()) wrong = "refused without a word";
    } catch (const std::exception& error) {
        wrong = error.what();
    }
    requests_are_limited = false;
    EXPECT_EQ(wrong, "") << "the file was:\n" << content;
    return accepted;
}

}  // namespace

TEST(DamagedRecords, are_refused_in_words_or_read_as_sound_records)
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
TEST(DamagedRecords, come_from_sound_ones)
{
    for (const std::filesystem::path& file : seeds()) {
        if (file.filename() == "decimal_commas.csv") continue;  // looks like one and is none
        const std::string sound = read_text(file);
        const bool good = accepts(sound, {}) || accepts(sound, {.unit = "g"}) ||
                          accepts(sound, {.unit = "g", .time_step = 0.01});
        EXPECT_TRUE(good) << file.filename();
    }
}

}  // namespace voussoir
