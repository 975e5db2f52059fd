// Reading a text as a record, in one line of a test.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "libdda/errors.h"
#include "records/record.h"
#include "tests/records/test_files.h"

namespace voussoir::records
{

inline Record read(const std::string& content, const ReadOptions& options = {})
{
    const TemporaryFile file(content);
    return read_record(file.path(), options);
}

/// The faults of a file that must be refused, one line each.
inline std::string refusal(const std::string& content, const ReadOptions& options = {})
{
    const TemporaryFile file(content);
    try {
        read_record(file.path(), options);
    } catch (const InputError& error) {
        EXPECT_NE(error.faults.front().place.find(file.path().string()), std::string::npos);
        return error.what();
    }
    ADD_FAILURE() << "accepted: " << content;
    return "";
}

inline void expect_in(const std::string& text, const std::string& part)
{
    EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is not in \"" << text << "\"";
}

inline ReadOptions in_g()
{
    return {.unit = "g"};
}
inline ReadOptions in_g(double time_step)
{
    return {.unit = "g", .time_step = time_step};
}

}  // namespace voussoir::records
