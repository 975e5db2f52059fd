// What a FDSN StationXML file says of one channel: its sensitivity and its direction.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "records/formats/format.h"

namespace voussoir::records::formats
{

struct ChannelCode {
    std::string network, station, location, channel;
};

/// "SL.KOGS..HNE"
std::string to_text(const ChannelCode& code);

/// Makes the samples of a channel, in counts, motion by the total sensitivity of its epoch in the StationXML file,
/// and takes its azimuth from there. Flat: no poles, no zeros; a remark says so.
/// @param start UTC of the first sample, "2020-03-22T05:23:58"; empty when it is not known
/// @throws InputError when the file has no such channel at that time, several, or no sensitivity to motion
void apply_response(const std::filesystem::path& station_xml, const ChannelCode& code, const std::string& start,
                    Channel& channel, std::vector<std::string>& remarks);

/// The unit of counts: the user's, or none. Adds a fault when the options give both a unit and a response.
Unit resolve_unit_of_counts(const ReadOptions& options, const std::string& place, FaultList& faults);

}  // namespace voussoir::records::formats
