// What a reader of one file format is. A new format is one file that defines one of these, and one line in the
// table of record.cpp.
#pragma once

#include <span>

#include "records/record.h"
#include "records/source_file.h"
#include "records/units.h"

namespace voussoir::records::formats
{

struct Format {
    const char* name;
    /// Judges by content, never by the file's name.
    bool (*recognises)(const SourceFile&);
    /// @throws InputError with every fault of the file and of the options it needs
    Record (*read)(const SourceFile&, const ReadOptions&);
    /// Holds counts, which ReadOptions::response turns into motion.
    bool may_hold_counts = false;
};

extern const Format peer_at2;
extern const Format corrected_acc;
extern const Format csmip;
extern const Format cosmos;
extern const Format smc;
extern const Format usc;
extern const Format geonet;
extern const Format bhrc;
extern const Format cwb;
extern const Format dyna;
extern const Format eqsig;
extern const Format block_text;
extern const Format isesd;
extern const Format knet;
extern const Format miniseed;
extern const Format sac_format;
extern const Format text_table;
extern const Format unam;

/// Every format, in the order in which files are asked whether they are one (all_formats.cpp).
std::span<const Format* const> all_formats();

/// Reads a file that `format` recognises. @throws InputError also when there is no channel or a
/// sample overflows in SI
Record read_as(const Format& format, const SourceFile& source, const ReadOptions& options);

// ---- what readers share (format.cpp)

/// The unit, from the file's header, or from the options when the header has none (empty) or one we do not know.
/// Adds a fault when the two differ. @returns the unit; without a name, and with factor 1, when it is not known
Unit resolve_unit(const std::string& in_header, const ReadOptions& options, const std::string& place,
                  FaultList& faults);

/// The time step, from the file (nothing when it has none) or from the options; as resolve_unit.
/// @returns [s], or 1 after a fault
double resolve_time_step(std::optional<double> in_file, const ReadOptions& options, const std::string& place,
                         FaultList& faults);

/// Adds the fault of a line that should hold numbers only: the word that is none, or its decimal commas.
void add_row_fault(const SourceFile& file, std::size_t line, const std::string& expected, FaultList& faults);

/// All numbers of the lines from `first` on, touching Fortran numbers included; blank lines are passed over. Adds
/// a fault for each line that holds anything but finite numbers.
/// @throws InputError at the first line with decimal commas, for they stand on all of them
std::vector<double> read_fortran_samples(const SourceFile& file, std::size_t first, FaultList& faults);

/// Adds a fault when the header announces another number of samples than there are, or fewer than 2.
void check_count(double announced, std::size_t found, const std::string& place, FaultList& faults);

/// A column belongs to a text table: adds a fault when one was asked for.
void refuse_column(const SourceFile& file, const ReadOptions& options, FaultList& faults);

/// The samples times their unit: a channel in SI.
Channel make_channel(std::string component, const Unit& unit, double time_step, std::vector<double> samples);

}  // namespace voussoir::records::formats
