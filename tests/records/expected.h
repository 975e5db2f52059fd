// Records nobody in this project wrote, against values computed elsewhere (expected.json beside them).
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "libdda/errors.h"
#include "records/record.h"
#include "tests/records/test_files.h"

namespace voussoir::records
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

    /// Reads the file and compares every channel, in the file's order.
    /// @param name "motions/elCentro.AT2"; @param format as the reader says it; empty: any
    Record check(const std::string& name, const ReadOptions& options, const std::string& format)
    {
        SCOPED_TRACE(name);
        if (!expected_.contains(name)) {
            ADD_FAILURE() << "nothing expected of it";
            return {};
        }
        const nlohmann::json& channels = expected_[name]["channels"];
        const Record record = read_record(data_folder() / name, options);
        if (!format.empty()) {
            EXPECT_EQ(record.format, format);
        }
        EXPECT_EQ(record.channels.size(), channels.size());
        for (std::size_t i = 0; i < std::min(record.channels.size(), channels.size()); ++i)
            check_channel(record.channels[i], channels[i]);
        return record;
    }

    /// Names whose expected format is `format`.
    std::vector<std::string> names(const std::string& format) const
    {
        std::vector<std::string> found;
        for (const auto& [name, record] : expected_.items())
            if (record.value("format", "") == format) found.push_back(name);
        return found;
    }

    nlohmann::json expected_;

 private:
    static void check_channel(const Channel& found, const nlohmann::json& channel)
    {
        SCOPED_TRACE(channel["component"].get<std::string>());
        EXPECT_EQ(found.samples.size(), channel["npts"].get<std::size_t>());
        if (channel["dt_s"].is_number())
            EXPECT_NEAR(found.time_step, channel["dt_s"].get<double>(), 1e-9);
        else
            EXPECT_EQ(found.time_step, 0);
        if (found.samples.empty()) return;
        const bool in_si = channel.contains("factor_to_m_s2") && channel["factor_to_m_s2"].is_number();
        EXPECT_EQ(has_unit(found), in_si);
        const double factor = in_si ? channel["factor_to_m_s2"].get<double>() : 1;
        EXPECT_NEAR(found.samples.front(), channel["first"].get<double>() * factor, 1e-6 * peak(found));
        EXPECT_NEAR(found.samples.back(), channel["last"].get<double>() * factor, 1e-6 * peak(found));
        EXPECT_NEAR(peak(found), std::abs(channel["peak_as_stored"].get<double>()) * factor, 1e-7 * peak(found));
        if (in_si) {
            EXPECT_NEAR(peak(found), channel["pga_m_s2"].get<double>(), 1e-7 * peak(found));
        }
        const auto at = channel["peak_index"].get<std::size_t>();
        EXPECT_NEAR(found.samples.at(at), channel["peak_as_stored"].get<double>() * factor, 1e-7 * peak(found));
    }
};

}  // namespace voussoir::records
