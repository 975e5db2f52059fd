// The chapters of a report.
#pragma once

#include "app/report/document.h"
#include "app/report/run_record.h"

namespace voussoir::app::report
{

/// "12.3", four digits at most.
std::string figure(double value);

/// What became of the run, in one sentence; what did not go as planned says so.
std::string first_line_of(const RunRecord& record);

/// Whether that line is no good news.
bool is_alarming(const RunRecord& record);

Section key_results(const RunRecord& record);
Section mechanism_section(const RunRecord& record);
Section what_was_analysed(const RunRecord& record);
Section motion_section(const RunRecord& record);  // without a motion it has nothing in it
Section stones_and_joints(const RunRecord& record);
Section how_well_computed(const RunRecord& record);
Section assumptions(const RunRecord& record);
Section how_to_reproduce(const RunRecord& record);

}  // namespace voussoir::app::report
