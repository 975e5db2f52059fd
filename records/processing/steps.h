// The steps one by one, as process() calls them.
#pragma once

#include <string>

#include "libdda/errors.h"
#include "records/processing/processing.h"

namespace voussoir::records::processing
{

/// Does a step on the channels and adds its sentence. @param place "processing[2]", for faults
void apply(const TimeWindow&, const std::string& place, ProcessedRecord&);
void apply(const AriasWindow&, const std::string& place, ProcessedRecord&);
void apply(const RemoveMean&, const std::string& place, ProcessedRecord&);
void apply(const RemoveBaseline&, const std::string& place, ProcessedRecord&);
void apply(const Taper&, const std::string& place, ProcessedRecord&);
void apply(const Butterworth&, const std::string& place, ProcessedRecord&);
void apply(const Resample&, const std::string& place, ProcessedRecord&);
void apply(const Scale&, const std::string& place, ProcessedRecord&);
void apply(const ScaleToPeak&, const std::string& place, ProcessedRecord&);
void apply(const ScaleToSpectrum&, const std::string& place, ProcessedRecord&);
void apply(const Rotate&, const std::string& place, ProcessedRecord&);
void apply(const CorrectEnd&, const std::string& place, ProcessedRecord&);
void apply(const Integrate&, const std::string& place, ProcessedRecord&);
void apply(const Differentiate&, const std::string& place, ProcessedRecord&);
void apply(const Match&, const std::string& place, ProcessedRecord&);

/// Parameters out of range, whatever the record. @param place "processing[2]"
void check_step(const ProcessingStep& step, const std::string& place, std::vector<Fault>& faults);

// ---- what steps share

/// Four significant digits, for sentences.
std::string figure(double value);

/// "m/s2", "m/s" or "m".
std::string si_unit(Quantity quantity);

/// "x 0.012 m/s2, y 0.03 m/s2": a figure of each channel.
std::string per_channel(const std::vector<Channel>& channels, const std::vector<double>& values,
                        const std::string& unit_suffix = "");

/// @throws InputError when a channel is not an acceleration. @param what "an end correction"
void require_accelerations(const std::vector<Channel>& channels, const std::string& place,
                           const std::string& what);

/// @throws InputError when the channels differ in time step or, if asked, count
void require_alike(const std::vector<Channel>& channels, const std::string& place, bool in_count);

inline double duration_of(const Channel& channel)
{
    return static_cast<double>(channel.samples.size() - 1) * channel.time_step;
}

}  // namespace voussoir::records::processing
