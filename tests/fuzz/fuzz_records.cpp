// A libFuzzer target: any bytes, read as a record. InputError is what a reader may answer; all else is a finding.
//
//   fuzz_records --formats                               lists the formats and ends
//   VOUSSOIR_FUZZ_FORMAT="PEER AT2" fuzz_records DIR     only the reader of that format, for what it recognises
//
// The first byte of an input chooses the options, see options_of; the rest is the file.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "libdda/errors.h"
#include "records/formats/format.h"
#include "tests/fuzz/accepted_record.h"

namespace
{

using namespace voussoir;
using namespace voussoir::records;
using namespace voussoir::records::formats;

const Format* only_format = nullptr;

/// Bits 0 to 2 choose the unit, 3 and 4 the time step, 5 to 7 the column; 0 is what a user gives who gives
/// nothing.
ReadOptions options_of(unsigned choice)
{
    static const std::array<const char*, 7> units{"g", "cm/s2", "m/s2", "cm/s", "mm", "furlong", ""};
    static const std::array<double, 3> time_steps{0.01, 0, 1e300};
    static const std::array<int, 7> columns{1, 2, 3, 4, 99, 0, -1};
    ReadOptions options;
    if ((choice & 7U) > 0) options.unit = units[(choice & 7U) - 1];
    if ((choice >> 3U & 3U) > 0) options.time_step = time_steps[(choice >> 3U & 3U) - 1];
    if ((choice >> 5U & 7U) > 0) options.column = columns[(choice >> 5U & 7U) - 1];
    return options;
}

Record read_with_only_format(std::string bytes, const ReadOptions& options)
{
    SourceFile source;
    load_source_bytes("fuzz", std::move(bytes), source);
    if (!only_format->recognises(source)) throw InputError("fuzz", "not this format", "another reader's business");
    return read_as(*only_format, source, options);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
    if (*argc > 1 && std::string((*argv)[1]) == "--formats") {
        for (const Format* format : all_formats()) std::puts(format->name);
        std::exit(0);
    }
    const char* wanted = std::getenv("VOUSSOIR_FUZZ_FORMAT");
    if (wanted == nullptr) return 0;
    for (const Format* format : all_formats())
        if (std::string(format->name) == wanted) only_format = format;
    if (only_format != nullptr) return 0;
    std::fprintf(stderr, "no format \"%s\": see fuzz_records --formats\n", wanted);
    std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0) return 0;
    const ReadOptions options = options_of(data[0]);
    std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
    try {
        check_accepted(only_format != nullptr ? read_with_only_format(std::move(bytes), options)
                                              : parse_record("fuzz", std::move(bytes), options));
    } catch (const InputError&) {
    }
    return 0;
}
