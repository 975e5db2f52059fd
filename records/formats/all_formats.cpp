#include <array>
#include <cmath>

#include "libdda/errors.h"
#include "libdda/text/utf.h"
#include "records/formats/format.h"

namespace voussoir::records::formats
{

namespace
{

// Asked in this order; a text table is the least particular.
const auto formats_in_order = std::to_array<const Format*>({
    &miniseed,
    &sac_format,
    &dyna,
    &knet,
    &cwb,
    &unam,
    &isesd,
    &csmip,
    &cosmos,
    &smc,
    &usc,
    &geonet,
    &bhrc,
    &peer_at2,
    &corrected_acc,
    &eqsig,
    &block_text,
    &text_table,
});

}  // namespace

std::span<const Format* const> all_formats()
{
    return formats_in_order;
}

namespace
{

/// What no reader alone need think of: a file that ends before its first channel; the largest numbers, which
/// overflow when they are turned into SI.
void require_sound(const Record& record)
{
    if (record.channels.empty())
        throw InputError(record.file, "a header of " + record.format + " without samples",
                         "the file is cut short or damaged: download it again");
    for (const Channel& channel : record.channels)
        for (const double sample : channel.samples)
            if (!std::isfinite(sample))
                throw InputError(record.file, "samples so large that they overflow in SI", "check their unit");
}

/// Names come in the file's encoding; what leaves here is UTF-8.
void encode_names(Record& record)
{
    for (std::string* text : {&record.station, &record.event}) *text = text::as_utf8(*text);
    for (std::string& remark : record.remarks) remark = text::as_utf8(remark);
    for (Channel& channel : record.channels) {
        channel.component = text::as_utf8(channel.component);
        channel.unit_in_file = text::as_utf8(channel.unit_in_file);
    }
}

}  // namespace

Record read_as(const Format& format, const SourceFile& source, const ReadOptions& options)
{
    if (!options.response.empty() && !format.may_hold_counts)
        throw InputError(source.name, "a response was given, but " + std::string(format.name) + " holds no counts",
                         "omit the response");
    Record record = format.read(source, options);
    require_sound(record);
    encode_names(record);
    return record;
}

}  // namespace voussoir::records::formats
