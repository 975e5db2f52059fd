#include "tests/app/properties/generated_reading.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "app/reader/case_file.h"
#include "libdda/errors.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::properties
{

namespace
{

Case read_in_folder(const std::string& text, const std::map<std::string, std::string>& files)
{
    if (files.empty()) return reader::read_case_text("case.yaml", text, {});
    const TemporaryFolder folder;
    for (const auto& [name, content] : files) folder.write(name, content);
    return reader::read_case_text(folder / "case.yaml", text, {});
}

}  // namespace

std::pair<std::uint64_t, std::uint64_t> seeds(std::uint64_t usual)
{
    const char* given = std::getenv("VOUSSOIR_SEEDS");
    if (given == nullptr) return {0, usual};
    char* rest = nullptr;
    const std::uint64_t first = std::strtoull(given, &rest, 10);
    return {first, std::strtoull(rest, nullptr, 10)};
}

Case read(const GeneratedScene& scene, const Telling& telling)
{
    return read_in_folder(text_of(scene, telling), files_of(scene, telling));
}

std::optional<Case> read_damaged(std::uint64_t seed)
{
    const GeneratedScene scene = generated(seed);
    try {
        return read_in_folder(mutated(text_of(scene, {}), seed), files_of(scene, {}));
    } catch (const InputError& error) {
        for (const Fault& fault : error.faults) {
            EXPECT_NE(fault.place, "") << "seed " << seed;
            EXPECT_NE(fault.found, "") << "seed " << seed;
            EXPECT_NE(fault.expected, "") << "seed " << seed << ": " << fault.found;
        }
        return std::nullopt;
    }
}

void count(const std::map<std::string, int>& ends)
{
    for (const auto& [end, cases] : ends) ::testing::Test::RecordProperty("cases_" + end, std::to_string(cases));
}

}  // namespace voussoir::app::properties
