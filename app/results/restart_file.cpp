#include "app/results/restart_file.h"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "app/results/packed.h"
#include "app/results/restart_checks.h"
#include "app/results/state_fields.h"
#include "libdda/errors.h"

namespace voussoir::app::results
{

namespace
{

constexpr std::string_view mark = "voussoir restart 27\n";  // its number rises when the layout changes
constexpr const char* what = "a restart file";
constexpr std::size_t head_bytes = 1 + 8 + 8;  // whether it ended, its time, the bytes of what follows

// The lists of members below do not compile when a struct has got another one: then store that too.

template <typename Archive, typename Ledger>
void ledger_fields(Archive& archive, Ledger& ledger)
{
    auto& [kinetic, strain, contact, gravity, foundation, boundary, load, friction, damping_kinetic,
           damping_static, damping_contact, damping_material, fracture, yielding, impact, closing, algorithmic,
           algorithmic_rotation, redetection, start_kinetic, start_strain, start_contact, peak_stored, peak_taken,
           peak_given] = ledger;
    archive.fields(kinetic, strain, contact, gravity, foundation, boundary, load, friction, damping_kinetic,
                   damping_static, damping_contact, damping_material, fracture, yielding, impact, closing,
                   algorithmic, algorithmic_rotation, redetection, start_kinetic, start_strain, start_contact,
                   peak_stored, peak_taken, peak_given);
}

template <typename Archive, typename SomeDiagnosis>
void diagnosis_fields(Archive& archive, SomeDiagnosis& diagnosis)
{
    auto& [kind, stage, blocks, values] = diagnosis;
    archive.fields(kind, stage);
    archive.list(blocks);
    archive.list(values);
}

template <typename Archive, typename SomeVerdict>
void verdict_fields(Archive& archive, SomeVerdict& verdict)
{
    auto& [standing, lost, mass, lost_share, fastest, speed, go_on, blocks, damage, worst] = verdict;
    archive.fields(standing, mass, lost_share, fastest, speed, go_on, damage);
    archive.list(lost);
    archive.list(blocks, [](auto& to, auto& entry) {
        auto& [displacement, turn] = entry;
        to.fields(displacement, turn);
    });
    auto& [block_a, block_b, opening, slip, share] = worst;
    archive.fields(block_a, block_b, opening, slip, share);
}

template <typename Archive, typename Report>
void report_fields(Archive& archive, Report& report)
{
    auto& [outcome, diagnosis, steps, step_cuts, unconverged_steps, divided_steps, refused_steps, shorter_steps,
           open_close_iterations, factorisations, linear_iterations, factor_entries, acted, blows, simulated_time,
           max_penetration, deepest, static_unbalanced, energy, fallen, crushed, joints, bars, seconds, warnings,
           verdict] = report;
    archive.fields(outcome, steps, step_cuts, unconverged_steps, divided_steps, refused_steps,
                   open_close_iterations, factorisations, linear_iterations, factor_entries, simulated_time,
                   max_penetration, static_unbalanced, seconds);
    auto& [relaxed, whole_tangents, shortened] = acted;
    archive.fields(relaxed, whole_tangents, shortened, blows.solved, blows.unfinished);
    archive.list(shorter_steps, [](auto& to, auto& entry) {
        auto& [stage, time, time_step, at_start] = entry;
        to.fields(stage, time, time_step, at_start);
    });
    ledger_fields(archive, energy);
    auto& [share, depth, forgiven, overlap_time, overlap_a, overlap_b, drawn] = deepest;
    archive.fields(share, depth, forgiven, overlap_time, overlap_a, overlap_b, drawn);
    archive.list(fallen, [](auto& to, auto& entry) {
        auto& [block, time, left] = entry;
        to.fields(block, time, left);
    });
    archive.list(crushed, [](auto& to, auto& entry) {
        auto& [block_a, block_b, strength, first_time, worst_time, worst_stress, duration, longest, stretch,
               at_rest] = entry;
        to.fields(block_a, block_b, strength, first_time, worst_time, worst_stress, duration, longest, stretch,
                  at_rest);
    });
    const auto time = [](auto& to, auto& value) { to.field(value); };
    archive.list(joints, [&](auto& to, auto& entry) {
        auto& [block_a, block_b, opening, slip, opened, slid] = entry;
        to.fields(block_a, block_b, opening, slip);
        to.maybe(opened, time);
        to.maybe(slid, time);
    });
    archive.list(bars, [&](auto& to, auto& entry) {
        auto& [tension, compression, shear, yielded, out] = entry;
        to.fields(tension, compression, shear);
        to.maybe(yielded, time);
        to.maybe(out, time);
    });
    const auto told = [](auto& to, auto& entry) { diagnosis_fields(to, entry); };
    archive.maybe(diagnosis, told);
    archive.list(warnings, told);
    archive.maybe(verdict, [](auto& to, auto& entry) { verdict_fields(to, entry); });
}

template <typename Archive, typename Position>
void position_fields(Archive& archive, Position& position)
{
    auto& [report, frames, reference, before_motion, rested, stage_done, multiples, divisions, parts, halvings,
           at_halving, pace, load_increments, static_steps, quiet_steps, step_unbalanced, course] = position;
    report_fields(archive, report);
    archive.fields(frames, rested, stage_done, multiples, divisions, parts, halvings, load_increments,
                   static_steps, quiet_steps, step_unbalanced);
    auto& [put_in, integrator, closing, contacts] = at_halving;
    archive.fields(put_in, integrator, closing, contacts);
    archive.maybe(before_motion, [](auto& to, auto& ledger) { ledger_fields(to, ledger); });
    archive.list(reference);
    auto& [accelerations, time_step] = pace;
    archive.list(accelerations);
    archive.field(time_step);
    auto& [start, first_way, before, acceleration, steady, kinetic, idle, falls, asked_at, was_hard] = course;
    archive.maybe(start, [](auto& to, auto& began) {
        state_fields(to, began.state);
        report_fields(to, began.report);
    });
    archive.list(before);
    archive.fields(first_way, acceleration, steady, kinetic, idle, falls, asked_at, was_hard);
}

template <typename Archive, typename Start>
void trust_fields(Archive& archive, Start& start)
{
    auto& [at_rest, modes, energy] = start;
    archive.fields(at_rest, modes.outcome, modes.loose, modes.rigid);
    archive.list(modes.modes, [](auto& to, auto& mode) {
        auto& [frequency, mass_share, joint_share, lowered_by_joints, raised_by_stones, raised_by_corners,
               dashpot_time, rayleigh, hysteretic] = mode;
        to.field(frequency);
        to.field(mass_share);
        to.fields(joint_share, lowered_by_joints, raised_by_stones, raised_by_corners, dashpot_time,
                  rayleigh.of_mass, rayleigh.of_stiffness, hysteretic);
    });
    ledger_fields(archive, energy);
}

template <typename Archive, typename SomeRestart>
void restart_fields(Archive& archive, SomeRestart& restart)
{
    auto& from = restart.computed_from;
    auto& [version, commit, dirty, sources, compiled] = from.engine;
    archive.fields(version, commit, dirty, sources, compiled.instruction_set, compiled.compiler, compiled.eigen);
    archive.fields(from.text, from.overrides, from.blocks, from.motions);
    archive.list(restart.remarks);
    archive.fields(restart.history_rows, restart.wall_time, restart.cpu_time);
    archive.maybe(restart.trust, [](auto& to, auto& start) { trust_fields(to, start); });
    position_fields(archive, restart.position);
    state_fields(archive, restart.state);
}

}  // namespace

std::filesystem::path restart_file_in(const std::filesystem::path& folder)
{
    return folder / "restart.bin";
}

void save_restart(const Restart& restart, const std::filesystem::path& path)
{
    Packer rest;
    restart_fields(rest, restart);
    Packer packer;
    packer.fields(restart.ended, restart.state.time, static_cast<std::uint64_t>(rest.bytes.size()));
    packer.bytes += rest.bytes;
    write_packed(path, mark, packer.bytes);
}

RestartHead read_restart_head(const std::filesystem::path& path)
{
    RestartHead head;
    const std::string bytes = read_packed_head(path, mark, what, head_bytes);
    Unpacker unpacker(bytes);
    std::uint64_t rest = 0;
    unpacker.fields(head.ended, head.time, rest);
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    const std::uintmax_t around = mark.size() + head_bytes + sizeof(std::uint64_t);
    if (!unpacker.done() || error || size < around || size - around != rest || !std::isfinite(head.time))
        refuse_damaged(path);
    return head;
}

Restart load_restart(const std::filesystem::path& path)
{
    const RestartHead head = read_restart_head(path);  // the size is right, so it is not one that fills the memory
    const std::string payload = read_packed(path, mark, what);
    Unpacker unpacker(std::string_view(payload).substr(std::min(head_bytes, payload.size())));
    Restart restart;
    restart.ended = head.ended;
    restart_fields(unpacker, restart);
    if (!unpacker.done() || !is_sound(restart)) refuse_damaged(path);
    return restart;
}

void check_fits(const Restart& restart, const Case& the_case, const std::filesystem::path& path)
{
    if (!fits(restart, the_case))
        throw InputError(path.string(), "the restart of another case", "start the run again");
}

}  // namespace voussoir::app::results
