// Records nobody in this project wrote, against values computed elsewhere (expected.json beside them).

#include "tests/records/expected.h"

namespace voussoir::records
{

namespace
{

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
        EXPECT_FALSE(has_unit(read_record(data_folder() / name, {}).channels.front())) << name;
        check(name, {.unit = "g"}, "two-column text");
    }
}

TEST_F(RealRecords, ValuesOnlyFilesNeedAUnitAndAStep)
{
    const std::vector<std::string> files = names("values_only");
    EXPECT_GE(files.size(), 4);
    for (const std::string& name : files) {
        EXPECT_THROW(read_record(data_folder() / name, {}), InputError) << name;
        const double step = expected_[name]["dt_s"].get<double>();
        check(name, {.unit = "g", .time_step = step}, "values-only text");
    }
}

TEST_F(RealRecords, LAquilaFilesNeedNothingFromTheUser)
{
    const std::vector<std::string> files = names("smtk_cor_acc");
    EXPECT_GE(files.size(), 9);  // three of them gzipped
    for (const std::string& name : files) check(name, {}, "corrected acceleration (.cor.acc)");
}

TEST_F(RealRecords, TheTwoFilesOfElCentroAreOneMotion)
{
    const Record peer = read_record(data_folder() / "motions/elCentro.AT2", {});
    const Record plain = read_record(data_folder() / "motions/elCentro.dat", {.unit = "g", .time_step = 0.02});
    EXPECT_EQ(peer.channels[0].samples, plain.channels[0].samples);
    const GroundMotion motion = to_ground_motion(peer.channels[0], "El Centro");
    EXPECT_DOUBLE_EQ(motion.duration(), 31.16);
    EXPECT_NEAR(motion.peak_acceleration(), 3.1265562, 1e-7);
    EXPECT_NEAR(motion.with_end_correction().residual_displacement(), 0, 1e-12);
}

// Nothing in the folders is left out, whoever wrote a test for its format.
TEST_F(RealRecords, EveryFileIsReadOrRefusedAsExpected)
{
    int checked = 0, refused = 0;
    for (const char* folder : {"motions", "motions/laquila2009", "motions_restricted"})
        for (const auto& entry : std::filesystem::directory_iterator(data_folder() / folder)) {
            const std::string name = std::string(folder) + "/" + entry.path().filename().string();
            if (!entry.is_regular_file() || !expected_.contains(name)) continue;
            const nlohmann::json& channels = expected_[name]["channels"];
            if (channels.empty()) {
                EXPECT_THROW(read_record(data_folder() / name, {}), InputError) << name;
                ++refused;
                continue;
            }
            ReadOptions options;
            const std::string format = expected_[name].value("format", "");
            if (format == "two_col" || format == "values_only") options.unit = "g";
            if (format == "values_only") options.time_step = channels[0]["dt_s"].get<double>();
            check(name, options, "");
            ++checked;
        }
    EXPECT_EQ(checked + refused, static_cast<int>(expected_.size()));
    EXPECT_GE(refused, 1);
}

}  // namespace

}  // namespace voussoir::records
