// Records nobody in this project wrote, against values computed elsewhere (expected.json beside them).

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "libdda/errors.h"
#include "records/record.h"
#include "tests/records/test_files.h"

namespace voussoir
{

namespace
{

class RealRecords : public testing::Test
{
 protected:
    void SetUp() override
    {
        std::ifstream stream(data_folder() / "expected.json");
        if (!stream) GTEST_SKIP() << "no expected.json in " << data_folder();
        expected_ = nlohmann::json::parse(stream).at("motions");
    }

    void check(const std::string& name, const ReadOptions& options, const std::string& format)
    {
        SCOPED_TRACE(name);
        ASSERT_TRUE(expected_.contains(name));
        const nlohmann::json& channel = expected_[name]["channels"][0];
        const Record record = read_record(data_folder() / name, options);
        ASSERT_EQ(record.channels.size(), 1);
        const Channel& found = record.channels.front();
        EXPECT_EQ(record.format, format);
        EXPECT_EQ(found.samples.size(), channel["npts"].get<std::size_t>());
        EXPECT_NEAR(found.time_step, channel["dt_s"].get<double>(), 1e-9);
        const double factor = channel["factor_to_m_s2"].get<double>();
        EXPECT_NEAR(found.samples.front(), channel["first"].get<double>() * factor, 1e-6 * peak(found));
        EXPECT_NEAR(found.samples.back(), channel["last"].get<double>() * factor, 1e-6 * peak(found));
        EXPECT_NEAR(peak(found), channel["pga_m_s2"].get<double>(), 1e-7 * peak(found));
        const auto at = channel["peak_index"].get<std::size_t>();
        EXPECT_NEAR(found.samples.at(at), channel["peak_signed_m_s2"].get<double>(), 1e-7 * peak(found));
    }

    /// Names whose expected format is `format`.
    std::vector<std::string> names(const std::string& format) const
    {
        std::vector<std::string> found;
        for (const auto& [name, record] : expected_.items()) {
            const bool packed = record.value("gzip", false);
            if (record.value("format", "") == format && !packed) found.push_back(name);
        }
        return found;
    }

    nlohmann::json expected_;
};

TEST_F(RealRecords, PeerFilesNeedNothingFromTheUser)
{
    const std::vector<std::string> files = names("peer_at2");
    EXPECT_GE(files.size(), 8);
    for (const std::string& name : files) check(name, {}, "PEER AT2");
}

TEST_F(RealRecords, TwoColumnFilesNeedAUnit)
{
    const std::vector<std::string> files = names("two_col");
    EXPECT_GE(files.size(), 6);
    for (const std::string& name : files) {
        EXPECT_THROW(read_record(data_folder() / name, {}), InputError) << name;
        check(name, {.unit = "g", .time_step = {}, .column = {}}, "two-column text");
    }
}

TEST_F(RealRecords, ValuesOnlyFilesNeedAUnitAndAStep)
{
    const std::vector<std::string> files = names("values_only");
    EXPECT_GE(files.size(), 4);
    for (const std::string& name : files) {
        EXPECT_THROW(read_record(data_folder() / name, {}), InputError) << name;
        const double step = expected_[name]["dt_s"].get<double>();
        check(name, {.unit = "g", .time_step = step, .column = {}}, "values-only text");
    }
}

TEST_F(RealRecords, LAquilaFilesNeedNothingFromTheUser)
{
    const std::vector<std::string> files = names("smtk_cor_acc");
    EXPECT_GE(files.size(), 6);
    for (const std::string& name : files) check(name, {}, "corrected acceleration (.cor.acc)");
}

TEST_F(RealRecords, TheTwoFilesOfElCentroAreOneMotion)
{
    const Record peer = read_record(data_folder() / "motions/elCentro.AT2", {});
    const Record plain =
        read_record(data_folder() / "motions/elCentro.dat", {.unit = "g", .time_step = 0.02, .column = {}});
    EXPECT_EQ(peer.channels[0].samples, plain.channels[0].samples);
    const GroundMotion motion = to_ground_motion(peer.channels[0], "El Centro");
    EXPECT_DOUBLE_EQ(motion.duration(), 31.16);
    EXPECT_NEAR(motion.peak_acceleration(), 3.1265562, 1e-7);
    EXPECT_NEAR(motion.with_end_correction().residual_displacement(), 0, 1e-12);
}

TEST_F(RealRecords, FilesInFormatsNotReadAreRefusedNotMisread)
{
    int refused = 0;
    for (const auto& [name, record] : expected_.items()) {
        const std::string format = record.value("format", "");
        const bool readable =
            format == "peer_at2" || format == "two_col" || format == "values_only" || format == "smtk_cor_acc";
        if (readable && !record.value("gzip", false)) continue;
        EXPECT_THROW(read_record(data_folder() / name, {}), InputError) << name;
        ++refused;
    }
    EXPECT_GT(refused, 20);
}

}  // namespace

}  // namespace voussoir
