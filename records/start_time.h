// When channels begin: from the words of a header, and brought into step where they differ.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "records/record.h"

namespace voussoir::records
{

/// "2000/10/06 13:31:24", "20190728_160919.870", "2009-04-06T01:32:40.5": year, month, day, hour, minute, second,
/// whatever stands between them. @returns nothing when it is no date and time
std::optional<Instant> parse_instant(std::string_view text);

/// "2019-07-28T16:09:19".
std::string to_text(Instant instant);

/// Cuts channels that begin at different moments to the last of their beginnings, at the nearest sample. Where a
/// channel does not say when it begins, nothing is cut; that is said when it matters.
/// @param channels evenly sampled
/// @returns sentences on what was cut or could not be known; none when all begin together
/// @throws InputError when no moment is common to all
std::vector<std::string> bring_into_step(std::vector<Channel>& channels);

}  // namespace voussoir::records
