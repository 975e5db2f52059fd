// voussoir-generate-record: writes a synthetic accelerogram (noise.h) as a PEER AT2 file whose header names
// the command that makes it again.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "importers/process/program_start.h"
#include "libdda/errors.h"
#include "libdda/text/fortran_numbers.h"
#include "libdda/text/numbers.h"
#include "records/synthetic/noise.h"
#include "records/units.h"
#include "records/write_at2.h"

using voussoir::InputError;
using voussoir::records::Channel;
using voussoir::records::synthetic::SyntheticMotion;

namespace
{

struct Options {
    SyntheticMotion motion;
    double peak_g = 0.3;  // as typed, so that the header repeats it exactly
    std::string component = "X";
    std::filesystem::path output;
};

/// A number as records write it, to its last bit: CLI11 would read it as long double and round twice.
double number(const std::string& option, const std::string& word)
{
    double value = 0;
    if (!voussoir::text::parse_fortran_number(word, value))
        throw CLI::ValidationError(option, word + " is not a number");
    return value;
}

std::uint64_t whole_number(const std::string& option, const std::string& word)
{
    const double value = number(option, word);
    const bool exact =
        value >= 0 && value <= 0x1p53 && value == static_cast<double>(static_cast<std::uint64_t>(value));
    if (!exact) throw CLI::ValidationError(option, word + " is not a whole number from 0 to 2^53");
    return static_cast<std::uint64_t>(value);
}

void add_number(CLI::App& program, const std::string& name, double& value, const std::string& meaning)
{
    const auto read = [name, &value](const std::string& word) { value = number(name, word); };
    program.add_option_function<std::string>(name, read, meaning)
        ->type_name("NUMBER")
        ->default_str(voussoir::text::to_text(value));
}

void add_options(CLI::App& program, Options& options)
{
    SyntheticMotion& motion = options.motion;
    add_number(program, "--duration", motion.duration, "Length in s");
    add_number(program, "--time-step", motion.time_step, "Sampling in s");
    add_number(program, "--pga", options.peak_g, "Peak acceleration in g");
    add_number(program, "--ground-frequency", motion.ground_frequency, "Where the soil resonates, Hz");
    add_number(program, "--ground-damping", motion.ground_damping, "Damping ratio of the soil");
    add_number(program, "--high-pass", motion.high_pass_frequency, "Corner below which motion falls off, Hz");
    const auto read_seed = [&motion](const std::string& word) { motion.seed = whole_number("--seed", word); };
    program.add_option_function<std::string>("--seed", read_seed, "Of the noise: the same seed, the same record")
        ->type_name("NUMBER")
        ->default_str(std::to_string(motion.seed));
    program.add_option("--component", options.component, "Written into the header")
        ->type_name("NAME")
        ->capture_default_str();
    program.add_option("-o,--output", options.output, "The file to write")->required()->type_name("FILE");
}

/// The command that makes the same file again, every default spelled out.
std::string command(const Options& options)
{
    using voussoir::records::to_text;
    const SyntheticMotion& motion = options.motion;
    return "voussoir-generate-record --duration " + voussoir::text::to_text(motion.duration) + " --time-step " +
           voussoir::text::to_text(motion.time_step) + " --pga " + voussoir::text::to_text(options.peak_g) +
           " --ground-frequency " + voussoir::text::to_text(motion.ground_frequency) + " --ground-damping " +
           voussoir::text::to_text(motion.ground_damping) + " --high-pass " +
           voussoir::text::to_text(motion.high_pass_frequency) + " --seed " + std::to_string(motion.seed) +
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
    channel.samples = voussoir::records::synthetic::synthetic_acceleration(options.motion);
    const std::string title = "SYNTHETIC ACCELEROGRAM (filtered noise, not an earthquake), seed " +
                              std::to_string(options.motion.seed) + ", licence CC0 1.0";
    write_whole(options.output,
                voussoir::records::format_at2(title, command(options) + ", " + options.component, channel));
}

}  // namespace

int main(int argc, char** argv)
{
    voussoir::importers::process::begin_program();
    try {
        CLI::App program("A synthetic accelerogram in PEER's AT2 format", "voussoir-generate-record");
        Options options;
        add_options(program, options);
        try {
            program.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            return program.exit(error) == 0 ? 0 : 2;
        }
        options.motion.peak_acceleration = options.peak_g * voussoir::standard_gravity;
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
