#include "app/reader/motion_text.h"

#include "app/reader/record_source.h"
#include "app/reader/wave.h"
#include "libdda/errors.h"

namespace voussoir::app::reader
{

std::vector<records::Channel> parse_wave_motion(const std::string& text, const std::string& option,
                                                std::string& description)
{
    Findings findings;
    const YamlNode tree = parse_yaml(text, option, false);
    YamlCursor map(tree, option, findings);
    std::vector<records::Channel> channels;
    if (map.expect_map("a wave {ricker: {...}}")) {
        std::vector<std::string> found;
        for (const std::string& key : wave_keys())
            if (map.find(key)) found.push_back(key);
        if (found.size() == 1) {
            YamlCursor value = *map.find(found[0]);
            if (std::optional<records::Channel> wave = read_wave(found[0], value, description))
                if (const auto processed = process_as_written(map, {*wave}, {}, description))
                    channels = processed->channels;
        }
        map.find("processing");
        map.reject_unknown_keys();
        if (found.size() != 1 && findings.faults.empty())
            map.fault(found.empty() ? "no wave" : "two waves",
                      "give one of ramped_sine, sweep, ricker, pulse, noise");
    }
    if (!findings.faults.empty()) throw InputError(std::move(findings.faults));
    return channels;
}

}  // namespace voussoir::app::reader
