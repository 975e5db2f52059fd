#include "app/words/xml_text.h"

#include <gtest/gtest.h>

namespace voussoir::app::words
{

TEST(XmlText, NoTextEndsAnAttributeOrBeginsATag)
{
    EXPECT_EQ(xml_text("<b a=\"1\" c='2'> & x"), "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt; &amp; x");
    EXPECT_EQ(xml_text("&lt;"), "&amp;lt;");
}

TEST(XmlText, ControlCharactersBecomeBlanksAndAllElseStays)
{
    EXPECT_EQ(xml_text(std::string_view("a\0b\x1b]c", 6)), "a b ]c");
    EXPECT_EQ(xml_text("line\nline\tM\xc3\xbcnster"), "line\nline\tM\xc3\xbcnster");
}

}  // namespace voussoir::app::words
