// `voussoir record` as its user meets it.
#include <gtest/gtest.h>

#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "tests/app/program_start.h"
#include "tests/app/test_files.h"

namespace voussoir::app::commands
{
namespace
{

using nlohmann::json;
using std::numbers::pi;

/// Two columns, time and amplitude sin(2 pi frequency t).
std::string sine(double amplitude, double frequency, double step, int count)
{
    std::string text;
    for (int i = 0; i < count; ++i)
        text += std::to_string(i * step) + " " +
                std::to_string(amplitude * std::sin(2 * pi * frequency * i * step)) + "\n";
    return text;
}

/// What was complained of: on a busy machine also a record of a minute takes longer than the second after which
/// the program tells how far it is.
std::string errors_of(const Ended& ended)
{
    std::istringstream lines(ended.errors);
    std::string errors;
    for (std::string line; std::getline(lines, line);)
        if (line.find(": measuring, ") == std::string::npos) errors += line + "\n";
    return errors;
}

json listed(const Ended& ended)
{
    EXPECT_EQ(errors_of(ended), "");
    return json::parse(ended.output);
}

TEST(Record, WithoutAUnitIsListedWithoutPeak)
{
    const TemporaryFolder folder;
    const std::string file = folder.write("a.txt", sine(1, 2, 0.01, 100)).string();
    const Ended ended = voussoir(folder, {"record", file, "--json", "-"});
    EXPECT_EQ(ended.exit_code, 0);
    const json channel = listed(ended)[0]["channels"][0];
    EXPECT_EQ(channel["npts"], 100);
    EXPECT_NEAR(channel["dt_s"].get<double>(), 0.01, 1e-12);
    EXPECT_TRUE(channel["units_in_file"].is_null());
    EXPECT_TRUE(channel["pga_m_s2"].is_null());
    EXPECT_FALSE(channel.contains("arias_intensity_m_s"));
}

// The second was written over the first, with exit code 0.
TEST(Record, ChannelsOfOneNameHaveFilesOfTheirOwn)
{
    const TemporaryFolder folder;
    const std::string a = folder.write("a.txt", sine(2, 2, 0.01, 100)).string();
    const std::string b = folder.write("b.txt", sine(1, 3, 0.01, 100)).string();
    const std::string out = (folder.path() / "out").string();
    const Ended ended = voussoir(folder, {"record", a, b, "--together", "--unit", "m/s2", "-o", out});
    EXPECT_EQ(ended.exit_code, 0);
    const auto samples_of = [&](const std::string& name) {
        const json entry = listed(voussoir(folder, {"record", out + "/" + name, "--json", "-"}))[0];
        return entry["channels"][0]["pga_m_s2"].get<double>();
    };
    EXPECT_NEAR(samples_of("a_column2.at2"), 2, 1e-2);
    EXPECT_NEAR(samples_of("a_column2_2.at2"), 1, 1e-2);
}

// All oscillators walked one by one before, for 15 s.
TEST(Record, AMillionSamplesTakeSeconds)
{
    const TemporaryFolder folder;
    std::string text = "1000000 0.005\n";
    for (int i = 0; i < 1'000'000; ++i)
        text += std::to_string(std::exp(-1e-5 * std::abs(i - 500'000)) * std::sin(0.01 * i)) + "\n";
    const std::string file = folder.write("long.txt", text).string();
    rusage before{}, after{};
    getrusage(RUSAGE_CHILDREN, &before);
    const Ended ended = voussoir(folder, {"record", file, "--unit", "m/s2"});
    getrusage(RUSAGE_CHILDREN, &after);
    EXPECT_EQ(ended.exit_code, 0);
#if defined(__SANITIZE_ADDRESS__)
    constexpr int longest = 300;  // s
#else
    constexpr int longest = 6;
#endif
    EXPECT_LT(after.ru_utime.tv_sec - before.ru_utime.tv_sec, longest) << "2 s on a core of its own";
}

TEST(Record, UnevenSamplesHaveNoStepButAMotion)
{
    const TemporaryFolder folder;
    const std::string file = folder.write("a.txt", "0 0\n0.01 1\n0.025 -2\n0.03 0\n0.05 1\n").string();
    const json entry = listed(voussoir(folder, {"record", file, "--unit", "m/s2", "--json", "-"}))[0];
    const json& channel = entry["channels"][0];
    EXPECT_TRUE(channel["dt_s"].is_null());
    EXPECT_EQ(channel["npts"], 5);
    EXPECT_EQ(channel["pga_m_s2"], 2);
    EXPECT_FALSE(entry["remarks"].empty()) << "the user is told";
}

TEST(Record, MeasuresOfASineAreThoseOfItsClosedForm)
{
    const TemporaryFolder folder;
    const std::string file = folder.write("a.txt", sine(3, 2, 0.001, 2001)).string();
    const json channel =
        listed(voussoir(folder, {"record", file, "--unit", "m/s2", "--json", "-"}))[0]["channels"][0];
    const double w = 4 * pi;
    EXPECT_NEAR(channel["pga_m_s2"].get<double>(), 3, 1e-4);
    EXPECT_NEAR(channel["pgv_m_s"].get<double>(), 2 * 3 / w, 1e-4);
    EXPECT_NEAR(channel["arias_intensity_m_s"].get<double>(), pi / (2 * 9.80665) * 9, 1e-3);
    EXPECT_NEAR(channel["cav_m_s"].get<double>(), 2 * 3 * 2 / pi, 1e-3);
}

TEST(Record, ProcessesInTheOrderWrittenAndSaysSo)
{
    const TemporaryFolder folder;
    const std::string file = folder.write("a.txt", sine(3, 2, 0.01, 1001)).string();
    const json entry = listed(
        voussoir(folder, {"record", file, "--unit", "m/s2", "--process",
                          "[{window: {from: 2 s, to: 5 s}}, mean, {scale_to_pga: 0.1 g}]", "--json", "-"}))[0];
    ASSERT_EQ(entry["processing"].size(), 3) << entry["processing"];
    EXPECT_EQ(entry["channels"][0]["npts"], 301);
    EXPECT_NEAR(entry["channels"][0]["pga_m_s2"].get<double>(), 0.980665, 1e-9);
    const Ended wrong =
        voussoir(folder, {"record", file, "--unit", "m/s2", "--process", "[{windw: {from: 2 s}}]"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_NE(wrong.errors.find("window"), std::string::npos) << wrong.errors;
    const Ended unknown = voussoir(folder, {"record", file, "--process", "[mean]"});
    EXPECT_EQ(unknown.exit_code, 2) << "nothing is done to numbers without a unit";
}

TEST(Record, WritesTablesAndAt2ThatReadBackAlike)
{
    const TemporaryFolder folder;
    const std::string file = folder.write("a.txt", sine(3, 2, 0.01, 501)).string();
    const Ended ended = voussoir(folder, {"record", file, "--unit", "m/s2", "-o", (folder / "out").string()});
    EXPECT_EQ(ended.exit_code, 0) << ended.errors;
    for (const char* name : {"a.csv", "a_column2.at2", "a_spectra.csv"})
        EXPECT_TRUE(std::filesystem::exists(folder / "out" / name)) << ended.output;
    const Ended back = voussoir(folder, {"record", (folder / "out" / "a_column2.at2").string(),
                                         (folder / "out" / "a.csv").string(), "--unit", "m/s2", "--json", "-"});
    const json files = json::parse(back.output);
    EXPECT_EQ(back.exit_code, 2) << "AT2 is in g and says so";
    EXPECT_EQ(files[1]["channels"][0]["npts"], 501);
    const json at2 = listed(voussoir(
        folder, {"record", (folder / "out" / "a_column2.at2").string(), "--json", "-"}))[0]["channels"][0];
    EXPECT_EQ(at2["npts"], 501);
    EXPECT_NEAR(at2["pga_m_s2"].get<double>(), files[1]["channels"][0]["pga_m_s2"].get<double>(), 1e-6);
}

TEST(Record, MakesWaves)
{
    const TemporaryFolder folder;
    const json entry = listed(voussoir(
        folder, {"record", "--motion", "{ricker: {acceleration: 0.3 g, frequency: 2 Hz}}", "--json", "-"}))[0];
    EXPECT_NEAR(entry["channels"][0]["pga_m_s2"].get<double>(), 0.3 * 9.80665, 1e-9);
    EXPECT_NEAR(entry["channels"][0]["pgd_m"].get<double>(), 0.3 * 9.80665 / (2 * pi * pi * 4), 1e-4);
    EXPECT_EQ(voussoir(folder, {"record", "--motion", "{riker: {frequency: 2 Hz}}"}).exit_code, 2);
    EXPECT_EQ(voussoir(folder, {"record"}).exit_code, 2);
}

// The main shock at L'Aquila: the figures the issue names, three components as one motion.
TEST(Record, MainShockAtLAquila)
{
    const char* variable = std::getenv("VOUSSOIR_DATA");
    const std::filesystem::path data = variable != nullptr ? variable : VOUSSOIR_DEFAULT_DATA;
    const std::filesystem::path shock = data / "motions/laquila2009";
    if (!std::filesystem::exists(shock)) GTEST_SKIP() << "no data: set VOUSSOIR_DATA";
    const TemporaryFolder folder;
    const auto pga = [](const json& entry, int channel) {
        return entry["channels"][channel]["pga_m_s2"].get<double>();
    };
    const json alone = listed(voussoir(folder, {"record", (shock / "AQV_16837_H2.cor.acc").string(),
                                                (shock / "AQK_16889_V.cor.acc.gz").string(), "--json", "-"}));
    EXPECT_NEAR(pga(alone[0], 0), 6.507, 5e-4);  // WE
    EXPECT_NEAR(pga(alone[1], 0), 3.634, 5e-4);  // UP
    std::vector<std::string> words{"record", "--together", "--json", "-"};
    for (const char* part : {"H1", "H2", "V"})
        words.push_back((shock / ("AQG_16833_" + std::string(part) + ".cor.acc")).string());
    const json entry = listed(voussoir(folder, words))[0];
    ASSERT_EQ(entry["channels"].size(), 3);
    EXPECT_NEAR(pga(entry, 0), 5.069, 5e-4);  // NS
    EXPECT_EQ(entry["channels"][1]["azimuth_deg"], 90);
    EXPECT_TRUE(entry["channels"][2]["vertical"].get<bool>());
    ASSERT_TRUE(entry.contains("rotd"));
    const json& rotd50 = entry["rotd"]["rotd50_m_s2"];
    const json& rotd100 = entry["rotd"]["rotd100_m_s2"];
    for (std::size_t i = 0; i < rotd50.size(); ++i) EXPECT_LE(rotd50[i].get<double>(), rotd100[i].get<double>());
}

}  // namespace
}  // namespace voussoir::app::commands
