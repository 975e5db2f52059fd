// One document as a page, as Markdown, as JSON and as tables: nothing in a name is taken for markup or a formula.
#include "app/report/document.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/temporary_folder.h"

namespace voussoir::app::report
{
namespace
{

Document one_table(const std::string& name)
{
    Document document;
    document.title = name;
    document.first_line = "Completed";
    document.sections.push_back({name, {name}, {name}, {{"stones", name, {name}, {{name}}}}, {}, name});
    return document;
}

TEST(ReportDocument, APageEscapesEveryText)
{
    const std::string page = to_html(one_table("<b a=\"1\" b='2'>&\x01"));
    EXPECT_EQ(page.find("<b a="), std::string::npos);
    std::size_t times = 0;
    const std::string safe = "&lt;b a=&quot;1&quot; b=&#39;2&#39;&gt;&amp; ";
    for (std::size_t at = page.find(safe); at != std::string::npos; at = page.find(safe, at + 1)) ++times;
    EXPECT_EQ(times, 10U) << "title, heading, link, section, paragraph, point, caption, column, cell, text";
}

TEST(ReportDocument, MarkdownKeepsNamesPlain)
{
    const std::string text = to_markdown(one_table("a|b_c*d[e](f)<i>"), "/");
    EXPECT_NE(text.find("| a\\|b\\_c\\*d\\[e\\](f)\\<i\\> |"), std::string::npos) << text;
    EXPECT_NE(to_markdown(one_table("```\nrm\n```"), "/").find("````\n```\nrm\n```\n````"), std::string::npos)
        << "the fence is longer than any in the text";
}

TEST(ReportDocument, CsvIsQuotedAndNoFormula)
{
    const Table table{
        "t", "", {"name", "x [mm]"}, {{"a,\"b\"", "-1.5e-3"}, {"=cmd()", "nan"}, {"-5 apples", "+3"}}};
    EXPECT_EQ(to_csv(table), "name,x [mm]\n\"a,\"\"b\"\"\",-1.5e-3\n'=cmd(),nan\n'-5 apples,+3\n");
}

TEST(ReportDocument, PicturesAreInside)
{
    const TemporaryFolder folder;
    const struct {
        std::string bytes, base64;
    } samples[] = {{"Man", "TWFu"}, {"Ma", "TWE="}, {"M", "TQ=="}, {std::string("\xff\x00\xfe", 3), "/wD+"}};
    for (const auto& [bytes, base64] : samples) {
        Document document = one_table("x");
        document.sections[0].pictures = {{folder.write("p.png", bytes), "a picture"}};
        EXPECT_NE(to_html(document).find("src=\"data:image/png;base64," + base64 + "\""), std::string::npos);
    }
}

TEST(ReportDocument, LongTablesAreCutOnThePageAndWholeInJson)
{
    Document document = one_table("x");
    Table& table = document.sections[0].tables[0];
    table.rows.assign(100, {"row"});
    table.shown = 10;
    EXPECT_NE(to_html(document).find("90 more rows in report/stones.csv"), std::string::npos);
    const auto json = nlohmann::json::parse(to_json(document));
    EXPECT_EQ(json.at("sections").at(0).at("tables").at(0).at("rows").size(), 100U);
}

}  // namespace
}  // namespace voussoir::app::report
