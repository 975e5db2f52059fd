// Cases whose foundation moves: records in a folder of their own, and what is said about them.
#pragma once

#include <gtest/gtest.h>

#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{

inline constexpr double gravity = 9.80665;

/// Two boxes whose foundation moves as written, for as long as that lasts.
inline std::string moved_by(const std::string& motion)
{
    const std::string shaken =
        with(two_boxes, "{blocks: foundation}", "{blocks: foundation, motion: " + motion + "}");
    return with(shaken, ", duration: 0.2 s", "");
}

/// A folder with a case and its records.
class MotionCase : public testing::Test
{
 protected:
    Case read(const std::string& text) const { return read_case(folder_.write("case.yaml", text), {}); }
    std::string faults_of(const std::string& text) const
    {
        try {
            read(text);
        } catch (const InputError& error) {
            std::string all = error.what();
            const std::string prefix = (folder_ / "").string();
            for (std::size_t at = all.find(prefix); at != std::string::npos; at = all.find(prefix))
                all.erase(at, prefix.size());
            return all;
        }
        return "no fault";
    }
    /// A file of times, 0.01 s apart, and values.
    void write_record(const std::string& name, const std::vector<double>& values) const
    {
        std::string text;
        for (std::size_t i = 0; i < values.size(); ++i)
            text += std::to_string(0.01 * static_cast<double>(i)) + " " + std::to_string(values[i]) + "\n";
        folder_.write(name, text);
    }
    const TemporaryFolder folder_;
};

inline const FoundationMotion& motion_along(int component, const Case& the_case)
{
    for (const FoundationMotion& motion : the_case.stages.at(1).motions)
        if (motion.component == component) return motion;
    throw std::logic_error("no motion along this axis");
}

/// The only motion of the foundation, along x.
inline const GroundMotion& only_motion(const Case& the_case)
{
    EXPECT_EQ(the_case.stages.at(1).motions.size(), 1);
    return *motion_along(0, the_case).motion;
}

inline const std::string three_records =
    "records: [a.txt, b.txt, c.txt], unit: m/s2, azimuths: [10 deg, 100 deg, up]";
inline const std::vector<double> at_10{0, 1, -2, 0.5, 0}, at_100{0, 0.5, 1, -3, 0}, upwards{0, -0.25, 0.75, 2, 0};

/// The fixture with three records of one place.
class JointRecords : public MotionCase
{
 protected:
    JointRecords()
    {
        write_record("a.txt", at_10);
        write_record("b.txt", at_100);
        write_record("c.txt", upwards);
    }
};

}  // namespace voussoir::app::reader
