// Encodings, packings and contents that are no record.

#include "records/content.h"
#include "libdda/text/utf.h"

#include <zlib.h>

#include "libdda/text/fortran_numbers.h"
#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

const std::string peer =
    "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere, 1/2/2003, Station, 067\n"
    "ACCELERATION TIME SERIES IN UNITS OF M/S2\nNPTS= 3, DT= .01 SEC\n 1.5 -2\n 0.5\n";

std::string in_utf16(const std::string& text, bool little)
{
    std::string encoded = little ? "\xFF\xFE" : "\xFE\xFF";
    for (const char c : text) encoded += little ? std::string{c, '\0'} : std::string{'\0', c};
    return encoded;
}

std::string gzipped(std::string content)
{
    z_stream stream{};
    deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    std::string packed(content.size() + 100, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(content.data());
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

TEST(Content, ReadsTextsOfWindowsAndMacintosh)
{
    std::string with_cr = peer;
    for (char& c : with_cr)
        if (c == '\n') c = '\r';
    for (const std::string& content :
         {with_cr, in_utf16(peer, true), in_utf16(peer, false), gzipped(gzipped(peer))}) {
        const Record record = read(content);
        EXPECT_EQ(record.format, "PEER AT2");
        EXPECT_EQ(record.channels.at(0).samples, (std::vector<double>{1.5, -2, 0.5}));
    }
}

TEST(Content, TurnsNamesIntoUtf8)
{
    std::string latin = peer;
    latin.replace(latin.find("Station"), 7, "Orientaci\xF3n");
    EXPECT_EQ(read(latin).station, "Orientaci\xC3\xB3n");
    EXPECT_EQ(text::as_utf8("Orientaci\xC3\xB3n \xE2\x82\xAC"), "Orientaci\xC3\xB3n \xE2\x82\xAC");
    EXPECT_EQ(text::as_utf8("\xC3"), "\xC3\x83");
}

TEST(Content, NamesWhatIsNoRecord)
{
    expect_in(refusal(std::string("PK\x03\x04\x14\0\0\0", 8)), "a zip archive");
    expect_in(refusal(gzipped("a.EW" + std::string(253, '\0') + "ustar" + std::string(300, '\0'))),
              "a tar archive");
    expect_in(refusal("<!DOCTYPE html>\n<html>404</html>\n"), "a web page");
    expect_in(refusal("<?xml version=\"1.0\"?>\n<FDSNStationXML/>\n"), "an XML file");
    expect_in(refusal(peer + std::string(1, '\0') + "\n"), ":7: a text with a byte 0 in it");
    expect_in(refusal("t,a\n0,1,\n1,2,\n"), ":2: \"0,1,\" begins with a number but is no row of them");
    expect_in(refusal("no numbers\n"), "a text without a line of numbers");
    expect_in(refusal(std::string("\1\2\3\4\0\xFF", 6)), "binary content");
}

TEST(Content, TellsDecimalCommas)
{
    expect_in(refusal("t;a\n0,01;0,5\n0,02;0,6\n"), ":2: numbers with decimal commas");
    std::string peer_with_commas = peer;
    peer_with_commas.replace(peer_with_commas.find("1.5"), 3, "1,5");
    const std::string faults = refusal(peer_with_commas);
    expect_in(faults, ":5: numbers with decimal commas");
    EXPECT_EQ(faults.find("announces"), std::string::npos) << "one cause, one sentence: " << faults;
    EXPECT_TRUE(has_decimal_commas("-1,5"));
    for (const char* line : {"1,2,3", "1.5,2.5", "0.5, 1", "a,b", ",5,"})
        EXPECT_FALSE(has_decimal_commas(line)) << line;
}

TEST(Content, ReadsFortransExponentsOfThreeDigits)
{
    double value = 0;
    EXPECT_TRUE(text::parse_fortran_number("1.234-105", value));
    EXPECT_DOUBLE_EQ(value, 1.234e-105);
    EXPECT_TRUE(text::parse_fortran_number("-.5+100", value));
    EXPECT_DOUBLE_EQ(value, -0.5e100);
    for (const char* text : {"1234-105", "1.2-10", "1.2-1050", "1.2-105.5"})
        EXPECT_FALSE(text::parse_fortran_number(text, value)) << text;
    EXPECT_EQ(
        read("NPTS\nx\nIN UNITS OF M/S2\nNPTS= 3, DT= .01\n 1.5 1.2-105-2.0E+00\n").channels.at(0).samples[2], -2);
}

}  // namespace

}  // namespace voussoir::records
