// miniSEED 2 through libmseed: any number of channels, each in many records, in any order; every encoding libmseed
// knows. Samples are counts, without a unit unless the user gives one or a response.
//
// Source: [Seed2012]; decoded by libmseed 2.19.

#include <libmseed.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "libdda/text/numbers.h"
#include "libdda/text/words.h"
#include "records/formats/format.h"
#include "records/formats/keyed_header.h"
#include "records/formats/station_xml.h"

namespace voussoir::records::formats
{

namespace
{

constexpr const char* format_name = "miniSEED";
constexpr std::size_t fixed_header = 48;  // bytes

bool recognises(const SourceFile& file)
{
    if (file.bytes.starts_with("MS\x03")) return true;  // miniSEED 3: refused by name
    const char* bytes = file.bytes.data();
    return file.bytes.size() >= fixed_header && MS_ISVALIDHEADER(bytes);
}

/// One record: consecutive samples of one channel.
struct Piece {
    hptime_t start = 0;  // microseconds since 1970
    double rate = 0;     // Hz
    std::size_t offset = 0;
    std::vector<double> samples;
};

struct Trace {
    ChannelCode code;
    std::vector<Piece> pieces;
};

std::string at_byte(const SourceFile& file, std::size_t offset)
{
    return file.name + ", byte " + std::to_string(offset);
}

std::string time_text(hptime_t time, bool with_fraction)
{
    std::array<char, 40> buffer{};
    if (ms_hptime2isotimestr(time, buffer.data(), with_fraction ? 1 : 0) == nullptr) return "?";
    return buffer.data();
}

/// What libmseed has to say of a record, instead of on the terminal; a failed check of Steim's last sample among
/// it.
thread_local std::string complaint;

void keep_complaint(char* text)
{
    if (complaint.empty()) complaint = std::string(text::trim(text));
}

void pass_over(char* /*text*/) {}

void listen_to_libmseed()
{
    ms_loginit(pass_over, nullptr, keep_complaint, nullptr);
}

std::vector<double> samples_of(const MSRecord& record)
{
    const auto count = static_cast<std::size_t>(std::max<std::int64_t>(record.numsamples, 0));
    const auto copy = [&](const auto* first) { return std::vector<double>(first, first + count); };
    if (record.sampletype == 'i') return copy(static_cast<const std::int32_t*>(record.datasamples));
    if (record.sampletype == 'f') return copy(static_cast<const float*>(record.datasamples));
    if (record.sampletype == 'd') return copy(static_cast<const double*>(record.datasamples));
    return {};
}

Trace& trace_of(std::vector<Trace>& traces, const ChannelCode& code)
{
    for (Trace& trace : traces) {
        if (to_text(trace.code) == to_text(code)) return trace;
    }
    traces.push_back({code, {}});
    return traces.back();
}

/// A record that holds a text (a log) is passed over.
void add_piece(std::vector<Trace>& traces, const MSRecord& record, const SourceFile& file, std::size_t offset,
               FaultList& faults)
{
    const bool is_log = record.sampletype == 'a' || record.samplecnt == 0;
    if (is_log) return;
    Piece piece{record.starttime, record.samprate, offset, samples_of(record)};
    const auto is_finite = [](double sample) { return std::isfinite(sample); };
    if (static_cast<std::int64_t>(piece.samples.size()) != record.samplecnt)
        faults.add(at_byte(file, offset), "a record of fewer samples than it announces",
                   "download the file again");
    else if (!std::all_of(piece.samples.begin(), piece.samples.end(), is_finite))
        faults.add(at_byte(file, offset), "a sample that is not a finite number", "every sample must be finite");
    else
        trace_of(traces, {record.network, record.station, record.location, record.channel})
            .pieces.push_back(std::move(piece));
}

/// Bytes a sample takes at least; 0 for Steim, whose frames libmseed counts itself.
std::size_t bytes_per_sample(int encoding)
{
    switch (encoding) {
        case DE_INT32:
        case DE_FLOAT32:
            return 4;
        case DE_FLOAT64:
            return 8;
        case DE_GEOSCOPE24:
            return 3;
        case DE_ASCII:
            return 1;
        case DE_STEIM1:
        case DE_STEIM2:
            return 0;
        default:
            return 2;
    }
}

/// libmseed believes the announced count and reads past the record: what cannot fit is refused before.
bool holds_its_samples(const MSRecord& record)
{
    if (record.samplecnt == 0) return true;
    const auto length = static_cast<std::size_t>(record.reclen);
    const std::size_t begin = record.fsdh == nullptr ? 0 : record.fsdh->data_offset;
    const auto count = static_cast<std::size_t>(std::max<std::int64_t>(record.samplecnt, 0));
    return begin >= fixed_header && begin < length && count * bytes_per_sample(record.encoding) <= length - begin;
}

/// Unpacks the record at `here`. @returns what is wrong with it; empty when nothing is
std::string unpack(char* here, std::size_t left, MSRecord*& record)
{
    complaint.clear();
    const int length = static_cast<int>(std::min<std::size_t>(left, 1U << 30U));
    int outcome = msr_parse(here, length, &record, -1, 0, 0);
    if (outcome == MS_NOERROR && !holds_its_samples(*record)) return "a record of fewer samples than it announces";
    if (outcome == MS_NOERROR) outcome = msr_parse(here, length, &record, record->reclen, 1, 0);
    if (!complaint.empty()) return complaint;
    if (outcome > 0) return "a record that is cut short";
    return outcome == MS_NOERROR && record->reclen > 0 ? "" : ms_errorstr(outcome);
}

std::vector<Trace> read_traces(const SourceFile& file, FaultList& faults)
{
    listen_to_libmseed();
    std::vector<Trace> traces;
    std::string bytes = file.bytes;    // libmseed turns bytes round in place
    bytes.append(fixed_header, '\0');  // and may look a few past the end
    const std::size_t end = file.bytes.size();
    MSRecord* record = nullptr;
    const auto release = [](MSRecord** held) { msr_free(held); };
    const std::unique_ptr<MSRecord*, decltype(release)> guard(&record, release);
    for (std::size_t offset = 0; offset < end;) {
        const std::string fault = end - offset < fixed_header
                                      ? std::string("a record that is cut short")
                                      : unpack(bytes.data() + offset, end - offset, record);
        if (!fault.empty()) {
            faults.add(at_byte(file, offset), fault, "the file is cut short or damaged: download it again");
            break;
        }
        add_piece(traces, *record, file, offset, faults);
        offset += static_cast<std::size_t>(record->reclen);
    }
    return traces;
}

/// Puts the pieces in order of time and one after another. Adds a fault for each gap, overlap and change of rate.
std::vector<double> join(const SourceFile& file, Trace& trace, FaultList& faults)
{
    std::stable_sort(trace.pieces.begin(), trace.pieces.end(),
                     [](const Piece& a, const Piece& b) { return a.start < b.start; });
    std::vector<double> samples;
    const Piece* before = nullptr;
    for (const Piece& piece : trace.pieces) {
        if (before != nullptr && before->rate > 0) {
            const double step = 1e6 / before->rate;  // microseconds
            const double due =
                static_cast<double>(before->start) + step * static_cast<double>(before->samples.size());
            const double late = static_cast<double>(piece.start) - due;
            const std::string where = to_text(trace.code) + " at " + time_text(static_cast<hptime_t>(due), true);
            if (std::abs(piece.rate / before->rate - 1) > 1e-4)
                faults.add(at_byte(file, piece.offset), "another sample rate in " + where,
                           "one rate for a channel");
            else if (late > 0.5 * step)
                faults.add(at_byte(file, piece.offset),
                           "a gap of " + text::to_text(std::round(late) / 1e6) + " s in " + where,
                           "use a record without gaps, or cut it at the gap");
            else if (late < -0.5 * step)
                faults.add(at_byte(file, piece.offset),
                           "an overlap of " + text::to_text(std::round(-late) / 1e6) + " s in " + where,
                           "download the record again");
        }
        samples.insert(samples.end(), piece.samples.begin(), piece.samples.end());
        before = &piece;
    }
    return samples;
}

void add_channel(Record& record, const SourceFile& file, Trace& trace, const ReadOptions& options,
                 FaultList& faults)
{
    const std::string place = at_byte(file, trace.pieces.front().offset);
    const Unit unit = resolve_unit_of_counts(options, place, faults);
    const double time_step = resolve_time_step(1 / trace.pieces.front().rate, options, place, faults);
    std::vector<double> samples = join(file, trace, faults);
    if (samples.size() < 2) faults.add(place, "1 sample", "a record holds at least 2 samples");
    Channel channel = make_channel(to_text(trace.code), unit, time_step, std::move(samples));
    channel.start = Instant(std::chrono::microseconds(trace.pieces.front().start));
    orient_by_short_name(channel, trace.code.channel);
    faults.throw_if_any(file.name);
    if (!options.response.empty())
        apply_response(options.response, trace.code, time_text(trace.pieces.front().start, false), channel,
                       record.remarks);
    record.channels.push_back(std::move(channel));
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    if (file.bytes.starts_with("MS\x03"))
        throw InputError(file.name, "miniSEED 3", "convert it to miniSEED 2 (mseedconvert does)");
    FaultList faults;
    refuse_column(file, options, faults);
    std::vector<Trace> traces = read_traces(file, faults);
    faults.throw_if_any(file.name);
    if (traces.empty()) throw InputError(file.name, "no samples, only logs or headers", "a record with data");
    Record record{file.name, format_name, {}, traces.front().code.network + "." + traces.front().code.station};
    for (Trace& trace : traces) add_channel(record, file, trace, options, faults);
    return record;
}

}  // namespace

const Format miniseed{format_name, recognises, read, true};

}  // namespace voussoir::records::formats
