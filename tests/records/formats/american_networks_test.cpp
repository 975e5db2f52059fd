// Files of the American, New Zealand, Iranian and Chilean networks, as they came.

#include <array>

#include "records/formats/format.h"
#include "tests/records/expected.h"

namespace voussoir::records
{

namespace
{

void expect_azimuths(const Record& record, std::vector<std::optional<double>> azimuths)
{
    ASSERT_EQ(record.channels.size(), azimuths.size()) << record.file;
    for (std::size_t i = 0; i < azimuths.size(); ++i) {
        EXPECT_EQ(record.channels[i].azimuth, azimuths[i]) << record.file << ", channel " << i + 1;
        EXPECT_EQ(record.channels[i].is_vertical, !azimuths[i].has_value()) << record.file;
    }
}

TEST_F(RealRecords, CsmipFiles)
{
    const std::vector<std::string> files = names("csmip_v1");
    EXPECT_GE(files.size(), 4);
    for (const std::string& name : files) check(name, {}, "CSMIP volume 1/2");
    expect_azimuths(check("motions/CE89146.V1", {}, "CSMIP volume 1/2"), {0, std::nullopt, 90});
    const Record film = check("motions/LA116TH.RAW", {}, "CSMIP volume 1/2");
    expect_azimuths(film, {90, std::nullopt, 0});
    EXPECT_EQ(film.remarks.size(), 3) << "the printed times of each channel stray from even ones";
    const Record renadic = check("motions_restricted/altohospicio0911131.v1", {}, "CSMIP volume 1/2");
    expect_azimuths(renadic, {90, 0, std::nullopt});
    EXPECT_TRUE(renadic.remarks.empty());
    const Record second = check("motions/ce36456p_CE36456.V2", {}, "CSMIP volume 1/2");
    expect_azimuths(second, {90, std::nullopt, 0});
    ASSERT_EQ(second.remarks.size(), 1);
    EXPECT_NE(second.remarks.front().find("6 series of velocity or displacement"), std::string::npos);
    EXPECT_NE(second.station.find("PARKFIELD"), std::string::npos);
    EXPECT_NE(second.event.find("COALINGA"), std::string::npos);
}

TEST_F(RealRecords, SpectraOfCsmipAreRefused)
{
    try {
        read_record(data_folder() / "motions/CE89146.V3", {});
        ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("response spectra, not a time history"), std::string::npos);
    }
}

TEST_F(RealRecords, CosmosFiles)
{
    const std::vector<std::string> files = names("cosmos");
    EXPECT_GE(files.size(), 2);
    for (const std::string& name : files) check(name, {}, "COSMOS V0/V1/V2");
    const Record three = read_record(data_folder() / "motions/CE23837.V1C", {});
    expect_azimuths(three, {0, std::nullopt, 90});
    EXPECT_EQ(three.channels[1].component, "23837.HNZ.CE.--");
    EXPECT_TRUE(three.remarks.empty());
    // The same record in two formats.
    const Record csmip = read_record(data_folder() / "motions/CE23837.V1", {});
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(three.channels.at(i).samples, csmip.channels.at(i).samples);
}

TEST_F(RealRecords, SmcFiles)
{
    const std::vector<std::string> files = names("smc");
    EXPECT_GE(files.size(), 4);
    for (const std::string& name : files) check(name, {}, "USGS SMC");
    expect_azimuths(read_record(data_folder() / "motions/0111b.smc", {}), {std::nullopt});
    expect_azimuths(read_record(data_folder() / "motions/0111c.smc", {}), {270});
    const Record film = read_record(data_folder() / "motions/np01002r_4225a_u.smc", {});
    expect_azimuths(film, {133});
    ASSERT_EQ(film.channels.front().times.size(), 24879);
    EXPECT_DOUBLE_EQ(film.channels.front().times.back(), 35.963);
    const Channel even = resampled_evenly(film.channels.front());
    EXPECT_NEAR(peak(even), 2.2842, 0.01);
}

TEST_F(RealRecords, UscFiles)
{
    const std::vector<std::string> files = names("usc");
    EXPECT_GE(files.size(), 4);
    for (const std::string& name : files) {
        const Record record = check(name, {}, "USC");
        EXPECT_EQ(record.channels.front().times.size(), record.channels.front().samples.size());
    }
    expect_azimuths(read_record(data_folder() / "motions/017m30cc.y0a", {}), {0});
    expect_azimuths(read_record(data_folder() / "motions/017m30lw.s0a", {}), {90});
    expect_azimuths(read_record(data_folder() / "motions/017m30lw.s0b", {}), {std::nullopt});
}

TEST_F(RealRecords, GeonetFiles)
{
    const Record first = check("motions/20161113_110313_THZ_20.V1A", {}, "GeoNet V1A/V2A");
    expect_azimuths(first, {90, 0, std::nullopt});
    EXPECT_TRUE(first.remarks.empty());
    const Record second = check("motions/20161113_110259_WTMC_20.V2A", {}, "GeoNet V1A/V2A");
    expect_azimuths(second, {332, 242, std::nullopt});
    EXPECT_EQ(second.remarks.size(), 1);
    EXPECT_EQ(second.station, "WTMC");
}

TEST_F(RealRecords, BhrcFiles)
{
    const Record record = check("motions_restricted/5526-1.V1", {}, "BHRC volume 1");
    expect_azimuths(record, {50, std::nullopt, 140});
    EXPECT_EQ(record.station, "Avin");
    EXPECT_TRUE(record.remarks.empty());
}

TEST_F(RealRecords, NoFormatClaimsAnothersFile)
{
    const std::vector<std::pair<const formats::Format*, std::string>> readers{
        {&formats::peer_at2, "peer_at2"}, {&formats::corrected_acc, "smtk_cor_acc"},
        {&formats::csmip, "csmip_v"},     {&formats::cosmos, "cosmos"},
        {&formats::smc, "smc"},           {&formats::usc, "usc"},
        {&formats::geonet, "geonet_v"},   {&formats::bhrc, "bhrc"}};
    for (const auto& [name, record] : expected_.items()) {
        const std::string format = record.value("format", "");
        if (!std::filesystem::is_regular_file(data_folder() / name)) continue;
        SourceFile file;
        load_source_file(data_folder() / name, file);
        for (const auto& [reader, prefix] : readers)
            EXPECT_EQ(reader->recognises(file), format.starts_with(prefix)) << reader->name << ": " << name;
    }
}

}  // namespace

}  // namespace voussoir::records
