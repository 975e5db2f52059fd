// Results files whose content is not what it should be, and files that are none: refused in words. scripts/fuzz
// does the same for hours.
#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "libdda/errors.h"
#include "tests/damage.h"
#include "tests/fuzz/damaged_results.h"
#include "tests/limited_requests.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::results
{

namespace
{

/// "" when everything could be read, else the refusal.
std::string refusal(const std::filesystem::path& file)
{
    try {
        const LimitedRequests limit(20'000'000);
        read_everything(file);
    } catch (const InputError& error) {
        EXPECT_EQ(error.faults.size(), 1U);
        return error.what();
    }
    return "";
}

class Draft : public testing::TestWithParam<bool>
{
 protected:
    std::string refusal_of(const DraftResults& draft)
    {
        write_draft(draft, folder_.path() / "results.h5");
        return refusal(folder_.path() / "results.h5");
    }
    TemporaryFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(Planar, Draft, testing::Bool());

}  // namespace

TEST_P(Draft, ASoundOneIsRead)
{
    EXPECT_EQ(refusal_of(two_boxes(GetParam())), "");
}

TEST_P(Draft, EditsAtRandomAreRefusedOrHarmless)
{
    std::mt19937 engine(1999);
    std::size_t refused = 0;
    constexpr std::size_t tried = 600;
    for (std::size_t i = 0; i < tried; ++i) {
        std::string bytes(3 + engine() % 12, '\0');
        for (char& byte : bytes) byte = static_cast<char>(engine());
        DraftResults draft = two_boxes(GetParam());
        edit(bytes, draft);
        refused += !refusal_of(draft).empty();
    }
    std::printf("%zu of %zu edited files refused\n", refused, tried);
    EXPECT_GT(refused, tried / 4);
    EXPECT_LT(refused, tried);
}

TEST_P(Draft, WhatWouldLeadOutsideTheArraysIsRefused)
{
    const auto refused = [&](const char* name, double value) {
        DraftResults draft = two_boxes(GetParam());
        draft.numbers.at(name).values.back() = value;
        return refusal_of(draft);
    };
    for (const double outside : {-1.0, 2.0, 2147483647.0})
        EXPECT_NE(refused("/model/joint_of_groups", outside), "");
    EXPECT_NE(refused("/model/block_group", 9), "");
    EXPECT_NE(refused("/frames/count", -1), "");
    EXPECT_NE(refused("/frames/count", 3), "");
    EXPECT_NE(refused("/frames/count", 9e18), "");
    EXPECT_NE(refused("/frames/stage", 2), "");
    EXPECT_NE(refused("/frames/coordinates", std::nan("")), "");
    EXPECT_NE(refused("/frames/contacts/rows", 9e18), "");
    EXPECT_NE(refused("/frames/contacts/rows", -1), "");
    EXPECT_NE(refused("/frames/contacts/pair", 2), "");
    EXPECT_NE(refused("/joints/pair", 2), "");
    EXPECT_NE(refused("/joints/pair", -1), "");
    EXPECT_NE(refused("/model/foundations/block", 2), "");
    EXPECT_NE(refused("/model/mesh/face_vertices", 1000), "");
    EXPECT_NE(refused("/model/mesh/face_vertices", -1), "");
    EXPECT_NE(refused("/model/mesh/face_first", 1e6), "");
    EXPECT_NE(refused("/model/mesh/block_first_vertex", 1e6), "");
    EXPECT_NE(refused("/model/mesh/face_block", 2), "");
}

TEST_P(Draft, TextsThatAreNumbersAndSettingsThatAreNoneAreRefused)
{
    DraftResults draft = two_boxes(GetParam());
    draft.texts.at("/case/settings").at(0) = "[{\"name\":";
    EXPECT_NE(refusal_of(draft).find("no list of stages"), std::string::npos);
    draft = two_boxes(GetParam());
    draft.texts.erase("/model/block_names");
    draft.numbers["/model/block_names"] = {ElementType::float64, {2}, {1, 2}};
    EXPECT_NE(refusal_of(draft).find("holds no texts"), std::string::npos);
    draft = two_boxes(GetParam());
    draft.numbers.erase("/frames/time");
    draft.texts["/frames/time"] = {"0", "0.5"};
    EXPECT_NE(refusal_of(draft).find("holds no numbers"), std::string::npos);
}

}  // namespace voussoir::app::results
