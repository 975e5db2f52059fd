#include "app/words/lines.h"

#include <gtest/gtest.h>

namespace voussoir::app::words
{

using Lines = std::vector<std::string>;

TEST(Lines, EndAtNewlinesAndAtTheEnd)
{
    EXPECT_EQ(lines_of(""), Lines());
    EXPECT_EQ(lines_of("a"), Lines({"a"}));
    EXPECT_EQ(lines_of("a\n"), Lines({"a"}));
    EXPECT_EQ(lines_of("\na\r\n\nb"), Lines({"", "a\r", "", "b"}));
    EXPECT_EQ(lines_of("\n\n"), Lines({"", ""}));
}

}  // namespace voussoir::app::words
