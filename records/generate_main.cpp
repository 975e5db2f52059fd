// voussoir-generate-record: writes a synthetic accelerogram (noise.h) as a PEER AT2 file whose header names
// the command that makes it again.

#include <getopt.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "libdda/errors.h"
#include "libdda/text/fortran_numbers.h"
#include "libdda/text/numbers.h"
#include "records/synthetic/noise.h"
#include "records/units.h"
#include "records/write_at2.h"

using voussoir::Channel;
using voussoir::InputError;
using voussoir::SyntheticMotion;

namespace
{

constexpr const char* usage =
    R"(voussoir-generate-record [options] -o FILE: a synthetic accelerogram in PEER's AT2 format

  --duration S         length                                        [10]
  --time-step S        sampling                                      [0.005]
  --pga G              peak acceleration in g                        [0.3]
  --ground-frequency F where the soil resonates, Hz                  [3]
  --ground-damping Z   damping ratio of the soil                     [0.4]
  --high-pass F        corner below which motion falls off, Hz       [0.3]
  --seed N             of the noise: the same seed, the same record  [1]
  --component NAME     written into the header                       [X]
  -o, --output FILE    the file to write
  -h, --help           this text
)";

struct Options {
    SyntheticMotion motion;
    double peak_g = 0.3;  // as typed, so that the header repeats it exactly
    std::string component = "X";
    std::filesystem::path output;
    bool help = false;
};

enum OptionCode { duration = 1000, time_step, pga, ground_frequency, ground_damping, high_pass, seed, component };

const option long_options[] = {{"duration", required_argument, nullptr, duration},
                               {"time-step", required_argument, nullptr, time_step},
                               {"pga", required_argument, nullptr, pga},
                               {"ground-frequency", required_argument, nullptr, ground_frequency},
                               {"ground-damping", required_argument, nullptr, ground_damping},
                               {"high-pass", required_argument, nullptr, high_pass},
                               {"seed", required_argument, nullptr, seed},
                               {"component", required_argument, nullptr, component},
                               {"output", required_argument, nullptr, 'o'},
                               {"help", no_argument, nullptr, 'h'},
                               {nullptr, 0, nullptr, 0}};

double number(const char* text)
{
    double value = 0;
    if (!voussoir::parse_fortran_number(text, value)) throw InputError("command line", text, "give a number");
    return value;
}

std::uint64_t whole_number(const char* text)
{
    const double value = number(text);
    const bool exact =
        value >= 0 && value <= 0x1p53 && value == static_cast<double>(static_cast<std::uint64_t>(value));
    if (!exact) throw InputError("command line: --seed", text, "give a whole number from 0 to 2^53");
    return static_cast<std::uint64_t>(value);
}

Options parse(int argc, char** argv)
{
    Options options;
    for (int code = 0; (code = getopt_long(argc, argv, "o:h", long_options, nullptr)) != -1;) {
        switch (code) {
            case duration:
                options.motion.duration = number(optarg);
                break;
            case time_step:
                options.motion.time_step = number(optarg);
                break;
            case pga:
                options.peak_g = number(optarg);
                break;
            case ground_frequency:
                options.motion.ground_frequency = number(optarg);
                break;
            case ground_damping:
                options.motion.ground_damping = number(optarg);
                break;
            case high_pass:
                options.motion.high_pass_frequency = number(optarg);
                break;
            case seed:
                options.motion.seed = whole_number(optarg);
                break;
            case component:
                options.component = optarg;
                break;
            case 'o':
                options.output = optarg;
                break;
            case 'h':
                options.help = true;
                break;
            default:
                throw InputError("command line", "unknown or incomplete option", "see --help");
        }
    }
    if (options.help) return options;
    if (optind < argc) throw InputError("command line", argv[optind], "is not an option; see --help");
    if (options.output.empty()) throw InputError("command line", "no -o FILE", "name the file to write");
    options.motion.peak_acceleration = options.peak_g * voussoir::standard_gravity;
    return options;
}

/// The command that makes the same file again, every default spelled out.
std::string command(const Options& options)
{
    using voussoir::to_text;
    const SyntheticMotion& motion = options.motion;
    return "voussoir-generate-record --duration " + to_text(motion.duration) + " --time-step " +
           to_text(motion.time_step) + " --pga " + to_text(options.peak_g) + " --ground-frequency " +
           to_text(motion.ground_frequency) + " --ground-damping " + to_text(motion.ground_damping) +
           " --high-pass " + to_text(motion.high_pass_frequency) + " --seed " + std::to_string(motion.seed) +
           " --component " + options.component + " -o " + options.output.filename().string();
}

/// Written beside and renamed, so that no half of a record is ever left.
void write_whole(const std::filesystem::path& path, const std::string& text)
{
    std::filesystem::path part = path;
    part += ".part";
    std::ofstream stream(part, std::ios::binary);
    stream << text;
    stream.close();
    std::error_code error;
    if (stream) std::filesystem::rename(part, path, error);
    if (stream && !error) return;
    std::filesystem::remove(part, error);
    throw InputError(path.string(), "cannot be written", "check the folder and its permissions");
}

void generate(const Options& options)
{
    Channel channel;
    channel.component = options.component;
    channel.time_step = options.motion.time_step;
    channel.samples = voussoir::synthetic_acceleration(options.motion);
    const std::string title = "SYNTHETIC ACCELEROGRAM (filtered noise, not an earthquake), seed " +
                              std::to_string(options.motion.seed) + ", licence CC0 1.0";
    write_whole(options.output, format_at2(title, command(options) + ", " + options.component, channel));
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        const Options options = parse(argc, argv);
        if (options.help) {
            std::fputs(usage, stdout);
            return 0;
        }
        generate(options);
        return 0;
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "voussoir-generate-record: %s\n", error.what());
        return 1;
    }
}
