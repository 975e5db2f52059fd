// Names of others in tables that a spreadsheet opens.
#include "app/words/csv_cell.h"

#include <gtest/gtest.h>

namespace voussoir::app::words
{
namespace
{

TEST(CsvCell, NamesAndNumbersStay)
{
    for (const char* text : {"voussoir_12 ux [m]", "time [s]", "-0.25", "+3e-5", "", "a=b", "1-2"})
        EXPECT_EQ(csv_cell(text), text);
}

TEST(CsvCell, WhatBeginsAFormulaGetsAnApostrophe)
{
    EXPECT_EQ(csv_cell("=cmd|'/c calc'!A1"), "'=cmd|'/c calc'!A1");
    for (const char* text : {"@SUM(A1)", "+1+1", "-2+3", "-", "\tx", "-inf"})
        EXPECT_EQ(csv_cell(text), std::string("'") + text);
    EXPECT_EQ(csv_cell("=A1,\"B\""), "\"'=A1,\"\"B\"\"\"");
}

TEST(CsvCell, SeparatorsAreQuoted)
{
    EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
    EXPECT_EQ(csv_cell("a\nb"), "\"a\nb\"");
    EXPECT_EQ(csv_cell("\nb"), "\"'\nb\"");
}

}  // namespace
}  // namespace voussoir::app::words
