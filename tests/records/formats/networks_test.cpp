// CWB of Taiwan, UNAM of Mexico, ISESD of Europe, and eqsig's text.

#include <gtest/gtest.h>

#include "tests/records/expected.h"
#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

const std::string cwb_header =
    "#StationCode: ABC\r\n#RecordLength(sec): 0.06\r\n#SampleRate(Hz): 50\r\n#AmplitudeUnit:  gal. "
    "DCoffset(corr)\r\n"
    "#DataSequence: Time U(+); N(-); E(+)\r\n#Data: 4F10.3\r\n";

TEST_F(RealRecords, CwbFilesNeedNothingFromTheUser)
{
    const std::vector<std::string> files = names("cwb");
    EXPECT_GE(files.size(), 1);
    for (const std::string& name : files) {
        const Record record = check(name, {}, "CWB (Taiwan)");
        EXPECT_TRUE(record.channels.at(0).is_vertical);
        EXPECT_EQ(record.channels.at(1).azimuth, 0);
        EXPECT_EQ(record.channels.at(2).azimuth, 90);
    }
}

TEST(Cwb, ReadsEveryComponentItsDirectionAndItsSense)
{
    const Record record = read(cwb_header + " 0.000 1 2 3\r\n 0.020 4 5 6\r\n 0.040 7 8 9\r\n");
    ASSERT_EQ(record.channels.size(), 3);
    EXPECT_EQ(record.channels[1].component, "N");
    EXPECT_EQ(record.channels[1].azimuth, 180);
    EXPECT_DOUBLE_EQ(record.channels[2].samples.at(2), 0.09);
    EXPECT_DOUBLE_EQ(record.channels[0].time_step, 0.02);
}

TEST(Cwb, RefusesWithLine)
{
    expect_in(refusal(cwb_header + " 0.00 1 2 3\n 0.02 4 5 6\n"), ":2: the header announces 3 samples");
    expect_in(refusal(cwb_header + " 0.00 1 2 3\n 0.02 4 5\n 0.04 7 8 9\n"), ":8: not a row of 4 numbers");
    expect_in(refusal(cwb_header + " 0.00 1 2 3\n 0.02 4 inf 6\n 0.04 7 8 9\n"), ":8: sample inf");
    expect_in(refusal(cwb_header + " 0.00 1 2 3\n 0.02 4 5 6\n 0.06 7 8 9\n"), ":9: time 0.06 s");
    std::string still = cwb_header + " 0.00 1 2 3\n 0.02 4 5 6\n 0.04 7 8 9\n";
    still.replace(still.find(": 50"), 4, ": 0 ");
    expect_in(refusal(still), ":3: time step = inf s");
}

std::string unam(const std::string& count, const std::string& rows)
{
    return "*****\n   INSTITUTO DE INGENIERIA, UNAM\nARCHIVO ESTANDAR DE ACELERACION:\n"
           "CLAVE DE LA ESTACION                   : ABCD\n"
           "ORIENTACION C1-C6 (rumbo;orientacion)  : /V/N90W/S30E\n"
           "ORIENTACION C7-C12 (rumbo;orientacion) :\n"
           "INTERVALO DE MUESTREO, C1-C6 (s)       : /0.01/0.01/0.01\n"
           "NUM. TOTAL DE MUESTRAS, C1-C6          : /" +
           count + "/" + count + "/" + count +
           "  \nUNIDADES DE LOS DATOS                  : Gal (cm/s/s)\n====\nCALIDAD DEL ACELEROGRAMA:\nDUDOSO\n"
           "====\nDATOS DE ACELERACION:\n----+----+\n  CANAL-1\n  V  N90W  S30E\n----+----+\n" +
           rows;
}

TEST_F(RealRecords, UnamFilesNeedNothingFromTheUser)
{
    const std::vector<std::string> files = names("asa_unam");
    EXPECT_GE(files.size(), 1);
    for (const std::string& name : files) {
        const Record record = check(name, {}, "UNAM (ASA)");
        EXPECT_EQ(record.station, "ACAC");
        EXPECT_EQ(record.channels.at(1).azimuth, 90);
        expect_in(record.remarks.at(0), "announces 2455 samples but the file holds 2456");
    }
}

TEST(Unam, ReadsEveryChannelAndItsBearing)
{
    const Record record = read(unam("2", " 1.0  2.0  3.0\r\n 4.0 5.0 6.0\r\n"));
    ASSERT_EQ(record.channels.size(), 3);
    EXPECT_TRUE(record.channels[0].is_vertical);
    EXPECT_EQ(record.channels[1].azimuth, 270);
    EXPECT_EQ(record.channels[2].azimuth, 150);
    EXPECT_DOUBLE_EQ(record.channels[2].samples.at(1), 0.06);
    expect_in(record.remarks.at(0), "\"DUDOSO\"");
    EXPECT_EQ(read(unam("2", "1 2 3\n4 5 6\n7 8 9\n")).channels[0].samples.size(), 3);  // one more
    EXPECT_EQ(read(unam("2", "1 2\n4 5\n")).channels.size(), 2);  // a channel without samples
}

TEST(Unam, RefusesWithLine)
{
    expect_in(refusal(unam("3", "1 2 3\n4 5 6\n")), ":8: the header announces 3 samples but the file holds 2");
    expect_in(refusal(unam("1e12", "1 2 3\n4 5 6\n")), "1000000000000 samples");
    expect_in(refusal(unam("2", "1 2 3\n4 5\n")), ":20: not a row of 3 numbers");
    expect_in(refusal(unam("2", "1 2 3\n4 nan 6\n")), ":20: sample nan");
}

std::string isesd(const std::string& sections)
{
    return "file:                         000001xa.cor\nearthquake code:  990\nstation code:  694\n"
           "orientation of transducer:    NS\nsampling period:               0.010000s\n"
           "number of samples:             3\nunits:                        m/s*s, m/s, m & s\nreference:\n"
           "Somebody (2000)\n%- filtered\n" +
           sections;
}

TEST(Isesd, ReadsTheAccelerationOfItsSections)
{
    const Record record = read(
        isesd("-> corrected acceleration time histories\n-0.10000E-01-0.20000E-01\n 0.30000E-01\n"
              "-> corrected velocity time histories\n 1 2 3\n-> corrected displacement time histories\n 4 5 6\n"
              "STOP\n"));
    EXPECT_EQ(record.format, "ISESD");
    ASSERT_EQ(record.channels.size(), 1);
    EXPECT_EQ(record.channels[0].azimuth, 0);
    EXPECT_EQ(record.channels[0].unit_in_file, "m/s2");
    EXPECT_EQ(record.channels[0].samples, (std::vector<double>{-0.01, -0.02, 0.03}));
    EXPECT_DOUBLE_EQ(record.channels[0].time_step, 0.01);
    expect_in(record.remarks.at(0), "left out");
}

TEST(Isesd, ReadsVelocityAloneAndRefusesSpectra)
{
    const Record record = read(isesd("-> corrected velocity time histories\n 1 2 3\n"));
    EXPECT_EQ(record.channels.at(0).quantity, Quantity::velocity);
    EXPECT_EQ(record.channels[0].unit_in_file, "m/s");
    expect_in(refusal(isesd("-> PERIOD, SPECTRA\n 1 2 3\n")), ":11: \"-> PERIOD, SPECTRA\": not a time history");
    expect_in(refusal(isesd("-> corrected acceleration time histories\n 1 2\n")), ":6: the header announces 3");
    expect_in(refusal(isesd("-> corrected acceleration time histories\n 1 2\n 3x\n")),
              ":13: not a line of numbers");
}

TEST_F(RealRecords, EqsigFilesAreInMetresByConvention)
{
    const std::vector<std::string> files = names("eqsig");
    EXPECT_GE(files.size(), 1);
    for (const std::string& name : files) expect_in(check(name, {}, "eqsig").remarks.at(0), "eqsig's convention");
}

TEST(Eqsig, ReadsLabelCountAndStep)
{
    const Record record = read("some motion\n3 0.0100\n1\n-2\n3");
    EXPECT_EQ(record.format, "eqsig");
    EXPECT_EQ(record.channels.at(0).component, "some motion");
    EXPECT_DOUBLE_EQ(record.channels[0].samples.at(1), -2);
    EXPECT_DOUBLE_EQ(read("m\n3 0.01\n1\n-2\n3\n", in_g()).channels[0].samples.at(1), -2 * 9.80665);
    expect_in(refusal("some motion\n4 0.01\n1\n-2\n3\n"), ":2: the header announces 4 samples");
    expect_in(refusal("some motion\n3 0.0\n1\n-2\n3\n"), ":2: time step = 0 s");
    EXPECT_EQ(read("time acc\n2 0.1\n3 0.2\n4 0.3\n", in_g()).format, "two-column text");  // a table is not eqsig
}

}  // namespace

}  // namespace voussoir::records
