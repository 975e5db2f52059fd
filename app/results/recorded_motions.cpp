#include "app/results/recorded_motions.h"

#include <map>
#include <nlohmann/json.hpp>

#include "app/results/hdf5_file.h"
#include "libdda/errors.h"

namespace voussoir::app::results
{
namespace
{

/// When each dynamic stage begins [s], by its name.
std::map<std::string, double> starts_of_stages(const Hdf5File& file, const std::string& place)
{
    std::map<std::string, double> starts;
    double time = 0;
    try {
        for (const auto& stage : nlohmann::json::parse(file.read_text("/case/settings"))) {
            starts.emplace(stage.at("name").get<std::string>(), time);
            time += stage.value("duration_s", 0.0);
        }
    } catch (const nlohmann::json::exception&) {
        throw InputError(place, "settings that are no list of stages", "the file is damaged: run the case again");
    }
    return starts;
}

RecordedMotion read_motion(const Hdf5File& file, const std::string& group, const std::string& place)
{
    RecordedMotion motion;
    motion.source = file.text_attribute(group, "source");
    motion.stage = file.text_attribute(group, "stage");
    motion.peak_acceleration = file.number_attribute(group, "peak_acceleration_m_s2");
    motion.residual_velocity = file.number_attribute(group, "residual_velocity_m_s");
    motion.residual_displacement = file.number_attribute(group, "residual_displacement_m");
    motion.followers = file.read_texts(group + "/followers");
    const std::vector<double> samples = file.read<double>(group + "/samples");
    if (samples.size() % 4 != 0)
        throw InputError(place, group + "/samples does not have four columns",
                         "the file is damaged: run the case again");
    for (std::size_t i = 0; i < samples.size(); i += 4) {
        motion.times.push_back(samples[i]);
        motion.acceleration.push_back(samples[i + 1]);
        motion.velocity.push_back(samples[i + 2]);
        motion.displacement.push_back(samples[i + 3]);
    }
    return motion;
}

}  // namespace

std::vector<RecordedMotion> recorded_motions(const std::filesystem::path& results_file)
{
    const Hdf5File file = Hdf5File::open(results_file);
    const std::string place = results_file.string();
    const std::map<std::string, double> starts = starts_of_stages(file, place);
    std::vector<RecordedMotion> motions;
    for (int i = 1; file.has("/motions/motion_" + std::to_string(i)); ++i) {
        motions.push_back(read_motion(file, "/motions/motion_" + std::to_string(i), place));
        const auto start = starts.find(motions.back().stage);
        if (start != starts.end()) motions.back().start = start->second;
    }
    return motions;
}

}  // namespace voussoir::app::results
