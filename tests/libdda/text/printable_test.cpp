// What may command a terminal is shown, not sent.
#include "libdda/text/printable.h"

#include <gtest/gtest.h>

namespace voussoir::text
{
namespace
{

TEST(Printable, PlainWordsOfAllWritingsStay)
{
    for (const char* text : {"voussoir 12", "Sant'Agata è così", "θόλος", "拱桥", "\xF0\x9F\xA7\xB1", ""})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, ControlsAreShownAsBytes)
{
    EXPECT_EQ(printable("\x1B]52;c;aGk=\x07"), "\\x1B]52;c;aGk=\\x07");
    EXPECT_EQ(printable(std::string_view("a\0b\x7F", 4)), "a\\x00b\\x7F");
    EXPECT_EQ(printable("\xC2\x9B"
                        "31m"),
              "\\xC2\\x9B31m")
        << "the one-character form of an escape";
    EXPECT_EQ(printable("one\ntwo\r\tthree"), "one\\x0Atwo\\x0D\\x09three");
    EXPECT_EQ(printable_lines("one\ntwo\r"), "one\ntwo\\x0D");
}

TEST(Printable, MarksOfDirectionAreShown)
{
    EXPECT_EQ(printable("a\xE2\x80\xAE"
                        "b"),
              "a\\xE2\\x80\\xAE"
              "b");
    EXPECT_EQ(printable("\xE2\x81\xA6\xD8\x9C\xE2\x80\xA8"), "\\xE2\\x81\\xA6\\xD8\\x9C\\xE2\\x80\\xA8");
}

TEST(Printable, BytesThatAreNoTextAreShown)
{
    EXPECT_EQ(printable("\xFF"
                        "a\xC3"),
              "\\xFF"
              "a\\xC3");
    EXPECT_EQ(printable("\xED\xA0\x80"), "\\xED\\xA0\\x80") << "half of a pair";
    EXPECT_EQ(printable("\xC0\x8A"), "\\xC0\\x8A") << "a line end in two bytes";
}

TEST(Printable, JsonKeepsItsValues)
{
    EXPECT_EQ(printable_json("{\n \"a\": \"\xE2\x80\xAE\xC2\x9B\x7F\"}\n"),
              "{\n \"a\": \"\\u202e\\u009b\\u007f\"}\n");
    EXPECT_EQ(printable_json("\"\xC3\xA8\""), "\"\xC3\xA8\"");
}

}  // namespace
}  // namespace voussoir::text
