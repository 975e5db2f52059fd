#include "app/golden/hashes.h"

#include <cstring>
#include <string_view>

#include "libdda/run/run.h"

namespace voussoir::app::golden
{

namespace
{

/// FNV-1a of the bytes of numbers and texts.
class Hash
{
 public:
    void add(std::string_view bytes)
    {
        for (const char byte : bytes) value_ = (value_ ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
    }
    void add(double number) { add_bits(number); }
    void add(std::int64_t number) { add_bits(number); }
    void add(std::uint64_t number) { add_bits(number); }
    std::uint64_t value() const { return value_; }

 private:
    template <typename Number>
    void add_bits(Number number)
    {
        char bytes[sizeof(Number)];
        std::memcpy(bytes, &number, sizeof(Number));
        add(std::string_view(bytes, sizeof(Number)));
    }
    std::uint64_t value_ = 14695981039346656037ULL;
};

void add(const EnergyLedger& energy, Hash& hash)
{
    for (const double joules :
         {energy.kinetic, energy.strain, energy.contact, energy.gravity_work, energy.foundation_work,
          energy.boundary_work, energy.load_work, energy.friction, energy.damping_kinetic, energy.damping_static,
          energy.damping_contact, energy.fracture, energy.impact, energy.algorithmic, energy.algorithmic_rotation,
          energy.redetection, energy.peak_stored, energy.peak_given})
        hash.add(joules);
    if (energy.damping_material != 0) hash.add(energy.damping_material);  // scenes without it keep their hashes
    if (energy.yielding != 0) hash.add(energy.yielding);
    if (energy.closing != 0) hash.add(energy.closing);
}

}  // namespace

RunReport run_scene(const Scene& scene, State& end)
{
    end = scene.state;
    return run(scene.model, scene.stages, end, {});
}

std::uint64_t hash_of(const RunReport& report)
{
    Hash hash;
    hash.add(name_of(report.outcome));
    for (const std::int64_t count :
         {report.steps, report.step_cuts, report.unconverged_steps, report.divided_steps,
          report.open_close_iterations, report.factorisations, report.linear_iterations})
        hash.add(count);
    for (const double number : {report.simulated_time, report.max_penetration, report.static_unbalanced})
        hash.add(number);
    add(report.energy, hash);
    for (const FallenBlock& fallen : report.fallen) {
        hash.add(std::int64_t{fallen.block});
        hash.add(fallen.time);
    }
    for (const CrushedJoint& joint : report.crushed) {
        hash.add(std::int64_t{joint.block_a});
        hash.add(std::int64_t{joint.block_b});
        hash.add(joint.worst_stress);
        hash.add(joint.duration);
    }
    return hash.value();
}

std::vector<SceneHashes> hashes()
{
    std::vector<SceneHashes> all;
    for (const NamedScene& scene : scenes()) {
        State end;
        const RunReport report = run_scene(scene.make(), end);
        all.push_back({scene.name, voussoir::hash_of(end), hash_of(report)});
    }
    return all;
}

std::string behaviour(const std::vector<SceneHashes>& hashes)
{
    Hash whole;
    for (const SceneHashes& each : hashes) {
        whole.add(each.name);
        whole.add(each.state);
        whole.add(each.report);
    }
    constexpr int digits = 12;
    std::string text;
    for (int i = 0; i < digits; ++i) text += "0123456789abcdef"[(whole.value() >> (60 - 4 * i)) & 15];
    return text;
}

}  // namespace voussoir::app::golden
