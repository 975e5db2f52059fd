// What a study says, in sentences: the same on the terminal and on the page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/studies/converge/study.h"

namespace voussoir::app::studies::converge
{

/// "time step, newmark", "contact stiffness, newmark, at 1 ms".
std::string title_of(const Series& series);

/// "2 ms", "x 0.5": what the series varies.
std::string setting_in_words(const Series& series, const SeriesRow& row);

/// "2.2052 m", "-0.0031 m"; "-" when there is none.
std::string value_in_words(const std::optional<double>& value, const std::string& unit);

/// "0.13 %", "-" when there is none.
std::string share_in_words(const std::optional<double>& share);

/// The error of a row: "0.13 %"; "reference" of the finest run where that is what the others are compared with.
std::string error_of(const Series& series, const SeriesRow& row);

/// What became of a run beside its numbers: "failed: ...", "collapsed at 1.2 s, block 'b'"; mostly empty.
std::string remark_of(const SeriesRow& row);

/// Change of the quantity when the case's own stiffness (or the stiffest but one of the series) is doubled, as a
/// share of what it was. [-]
std::optional<double> change_per_doubling(const Series& series);

/// Observed order and reference; which settings meet 1 % and 5 %, or come closest; of a stiffness series the
/// sensitivity; the notes.
std::vector<std::string> verdict(const QuantityStudy& study, const Series& series);

}  // namespace voussoir::app::studies::converge
