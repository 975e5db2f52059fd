// Restart files, and the results they go on from, whose content is not what it should be though their checksums
// fit: refused in words, or harmless.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>

#include "app/results/frame_rows.h"
#include "app/results/histories.h"
#include "app/results/packed.h"
#include "app/results/restart_file.h"
#include "app/results/results_writer.h"
#include "app/results/state_file.h"
#include "app/words/diagnosis_words.h"
#include "app/words/trust_words.h"
#include "libdda/errors.h"
#include "libdda/run/run.h"
#include "tests/app/results/synthetic.h"
#include "tests/damage.h"
#include "tests/fuzz/damaged_results.h"
#include "tests/limited_requests.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::results
{

namespace
{

namespace fs = std::filesystem;

/// A drum on its ground, with one history.
Case small_case(Kinematics kinematics)
{
    Case result = synthetic::tower(kinematics, 1);
    result.output.histories = {{"top", "drum_1", {}}};
    return result;
}

/// In the dynamic stage, two frames and two lines of histories after the start.
Restart sound_restart(const Case& the_case)
{
    Restart restart;
    restart.computed_from = {
        {"0.1", "8951b6b97059", version::Dirty::yes, "0123456789ab", {"x86-64", "g++ 1", "3"}}, 1, 2, 3, 4};
    restart.state = synthetic::swaying(the_case, 0.5);
    restart.state.grid = 250;
    restart.state.stage_time = 250 * the_case.stages[1].control.time_step;
    restart.position.frames = 2;
    restart.position.multiples = 25;
    restart.position.report.steps = 250;
    restart.position.report.shorter_steps = {{1, 0.2, 1e-3, false}};
    restart.position.before_motion = EnergyLedger{};
    restart.position.halvings = 1;
    restart.position.report.fallen = {{1, 0.4, false}};
    restart.position.report.crushed = {{0, 1, 1e6, 0.1, 0.2, 2e6}};
    restart.position.report.joints = {{0, 1, 2e-3, 1e-5, 0.3, {}}};
    restart.position.report.warnings = {{DiagnosisKind::dry_joints, -1, {0, 1}, {1, 1e-3}}};
    restart.trust = TrustStart{true, {ModesOutcome::found, {{4.5, {0.8, 0, 0}, 0.1, 0.002, 0.1, 1e-4}}, 6}, {}};
    restart.history_rows = 2;
    return restart;
}

/// What stands between mark and checksum.
std::string payload_of(const std::string& file, const std::string& mark)
{
    return file.substr(mark.size(), file.size() - mark.size() - 8);
}

std::string mark_of(const std::string& file)
{
    return file.substr(0, file.find('\n') + 1);
}

/// Bytes changed where numbers stand: some have another sign or size then, or are none.
std::string with_odd_numbers(std::string bytes, Damage& damage)
{
    static const std::string odd[] = {std::string(8, '\0'),          std::string(8, '\xff'),
                                      std::string(7, '\0') + "\x7f", std::string("\xff\xff\xff\x7f", 4),
                                      std::string("\2\0\0\0", 4),    std::string("\0\0\0\0\0\0\xf0\x7f", 8)};
    for (std::size_t times = 1 + damage.below(3); times > 0; --times) {
        const std::string& value = odd[damage.below(std::size(odd))];
        bytes.replace(damage.below(bytes.size() - value.size()), value.size(), value);
    }
    return bytes;
}

class DamagedRestart : public testing::TestWithParam<Kinematics>
{
 protected:
    /// "" when a run could go on from it and did for a step.
    std::string refusal()
    {
        try {
            const LimitedRequests limit(20'000'000);
            const Restart restart = load_restart(file_);
            check_fits(restart, the_case_, file_);
            words::message_of(restart.position.report, the_case_.model, the_case_.stages);
            words::warnings_of(restart.position.report, the_case_.model, the_case_.stages);
            if (restart.trust)
                words::warnings_of(trust_in(*restart.trust, the_case_.stages, restart.position.report.energy),
                                   the_case_.stages);
            if (!restart.ended) go_on(restart);
        } catch (const InputError& error) {
            EXPECT_EQ(error.faults.size(), 1U);
            return error.what();
        }
        return "";
    }
    std::string refusal_of(const std::function<void(Restart&)>& change)
    {
        Restart restart = sound_restart(the_case_);
        change(restart);
        save_restart(restart, file_);
        return refusal();
    }
    void go_on(const Restart& restart)
    {
        State state = restart.state;
        RunObserver observer;
        observer.stop = [] { return true; };
        run(the_case_.model, the_case_.stages, state, observer, restart.position);
    }
    const Case the_case_ = small_case(GetParam());
    TemporaryFolder folder_;
    const fs::path file_ = folder_.path() / "restart.bin";
};
INSTANTIATE_TEST_SUITE_P(Kinematics, DamagedRestart,
                         testing::Values(Kinematics::spatial_deformable, Kinematics::spatial_rigid,
                                         Kinematics::planar_rigid));

/// A results file that a restart of the case goes on from, with two frames.
DraftResults draft_of(const Case& the_case)
{
    const bool planar = is_planar(the_case.model.kinematics);
    DraftResults draft = two_boxes(planar);
    const std::vector<WatchedJoint> joints = joints_at_start(the_case.model, initial_state(the_case.model));
    std::vector<GrowingDataset> datasets = frame_datasets(the_case.model, surface_mesh_of(the_case.model), joints);
    const std::size_t columns = Histories(the_case, {the_case.model, joints}).columns.size();
    datasets.push_back({"/histories/values", ElementType::float64, {columns}, {}});
    for (const GrowingDataset& dataset : datasets) {
        Extents extents = dataset.row;
        extents.insert(extents.begin(), 2);
        std::uint64_t count = 1;
        for (const std::uint64_t size : extents) count *= size;
        draft.numbers.insert({dataset.name, {dataset.type, extents, std::vector<double>(count, 0.25)}});
    }
    return draft;
}

class ResumedDraft : public testing::TestWithParam<bool>
{
 protected:
    /// "" when a run took the frames over.
    std::string refusal_of(const DraftResults& draft, const Restart& restart)
    {
        write_draft(draft, folder_.path() / "results.h5");
        const std::string before = content_of(folder_.path() / "results.h5");
        try {
            const LimitedRequests limit(100'000'000);
            const ResultsWriter writer(the_case_, folder_.path(), restart);
        } catch (const InputError& error) {
            EXPECT_EQ(content_of(folder_.path() / "results.h5"), before) << "refused, and changed";
            return error.what();
        }
        return "";
    }
    std::string refusal_of(const std::function<void(DraftResults&)>& change)
    {
        DraftResults draft = draft_of(the_case_);
        change(draft);
        return refusal_of(draft, sound_restart(the_case_));
    }
    const Case the_case_ = small_case(GetParam() ? Kinematics::planar_rigid : Kinematics::spatial_deformable);
    TemporaryFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(Planar, ResumedDraft, testing::Bool());

constexpr std::int64_t huge = std::numeric_limits<std::int64_t>::max();
constexpr int huge_int = std::numeric_limits<int>::max();

}  // namespace

TEST_P(DamagedRestart, ASoundOneGoesOn)
{
    EXPECT_EQ(refusal_of([](Restart&) {}), "");
    EXPECT_EQ(refusal_of([](Restart& r) { r = {}, r.ended = true; }), "");
}

// The fuzzer starts from it: of an older layout it would be refused at once, and nothing behind would be tried.
TEST(RestartSeed, HasTheLayoutOfToday)
{
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "restart.bin", seed = fs::path(VOUSSOIR_FUZZ_SEEDS) / "results/restart";
    save_restart(sound_restart(small_case(Kinematics::spatial_rigid)), file);
    const std::string good = content_of(file), mark = mark_of(good);
    if (std::getenv("VOUSSOIR_RENEW_SEEDS") != nullptr)
        std::ofstream(seed, std::ios::binary) << '\3' << payload_of(good, mark);
    write_packed(file, mark, content_of(seed).substr(1));
    EXPECT_NO_THROW(load_restart(file)) << "run this test once with VOUSSOIR_RENEW_SEEDS=1";
}

TEST(StateSeed, HasTheLayoutOfToday)
{
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "state", seed = fs::path(VOUSSOIR_FUZZ_SEEDS) / "results/state";
    save_state(State{}, file);
    write_packed(file, mark_of(content_of(file)), content_of(seed).substr(1));
    const State state = load_state(file);
    ASSERT_EQ(state.contacts.points.size(), 1);
    EXPECT_EQ(state.contacts.points[0].area, 0.1);
}

TEST_P(DamagedRestart, DamageWithoutAFittingChecksumIsRefused)
{
    save_restart(sound_restart(the_case_), file_);
    const std::string good = content_of(file_);
    Damage damage(77);
    for (int i = 0; i < 300; ++i) {
        const std::string bad = damage(good);
        if (bad == good) continue;
        folder_.write("restart.bin", bad);
        EXPECT_THROW(load_restart(file_), InputError);
    }
}

TEST_P(DamagedRestart, DamageUnderAFittingChecksumIsRefusedOrHarmless)
{
    save_restart(sound_restart(the_case_), file_);
    const std::string good = content_of(file_), mark = mark_of(good), payload = payload_of(good, mark);
    Damage damage(1755);
    constexpr int tried = 500;
    int refused = 0;
    for (int i = 0; i < tried; ++i) {
        const std::string bad = i % 8 == 0 ? damage(payload) : with_odd_numbers(payload, damage);
        write_packed(file_, mark, bad);
        refused += !refusal().empty();
    }
    std::printf("%d of %d restart files refused\n", refused, tried);
    EXPECT_GT(refused, tried / 4);
    EXPECT_LT(refused, tried);
}

TEST_P(DamagedRestart, ALengthBeyondTheFileAsksForNoMemory)
{
    for (const std::uint64_t length : {std::uint64_t{1} << 62U, std::uint64_t{1} << 40U, ~std::uint64_t{0}}) {
        Packer packer;
        packer.field(length);
        const std::string bytes = packer.bytes + std::string(1000, '\1');
        const LimitedRequests limit(100'000);
        std::vector<ContactPoint> points;
        Unpacker list(bytes);
        list.list(points, [](Unpacker& from, ContactPoint& point) { from.fields(point.gap, point.position); });
        EXPECT_FALSE(list.done());
        EXPECT_LE(points.size(), 1000U / 32 + 1);
        std::string text;
        Unpacker of_text(bytes);
        of_text.field(text);
        EXPECT_FALSE(of_text.done());
        EXPECT_EQ(text, "");
    }
}

TEST_P(DamagedRestart, WhatWouldLeadOutsideArraysOrCountsIsRefused)
{
    const auto refused = [&](auto change) { return !refusal_of(change).empty(); };
    const auto at = [&](auto change) { return refused([&](Restart& r) { change(r.position); }); };
    const auto report = [&](auto change) { return refused([&](Restart& r) { change(r.position.report); }); };
    const auto state = [&](auto change) { return refused([&](Restart& r) { change(r.state); }); };
    EXPECT_TRUE(report([](RunReport& r) { r.outcome = static_cast<Outcome>(17); }));
    EXPECT_TRUE(report([](RunReport& r) { r.outcome = static_cast<Outcome>(-1); }));
    EXPECT_TRUE(refused([](Restart& r) { r.trust->modes.outcome = static_cast<ModesOutcome>(17); }));
    EXPECT_TRUE(refused([](Restart& r) { r.trust->modes.loose = -1; }));
    EXPECT_TRUE(report([](RunReport& r) { r.steps = huge; }));
    EXPECT_TRUE(report([](RunReport& r) { r.fallen[0].block = 2; }));
    EXPECT_TRUE(report([](RunReport& r) { r.fallen[0].block = -1; }));
    EXPECT_TRUE(report([](RunReport& r) { r.crushed[0].block_a = huge_int; }));
    EXPECT_TRUE(report([](RunReport& r) { r.shorter_steps[0].stage = huge_int; }));
    EXPECT_TRUE(report([](RunReport& r) { r.shorter_steps[0].time_step = 0; }));
    EXPECT_TRUE(report([](RunReport& r) { r.crushed[0].block_b = 2; }));
    EXPECT_TRUE(report([](RunReport& r) { r.joints[0].block_b = 2; }));
    EXPECT_TRUE(report([](RunReport& r) { r.joints.clear(); }));
    EXPECT_TRUE(report([](RunReport& r) { r.joints.push_back(r.joints[0]); }));
    // What was said of the run is put into words: of blocks and stages that there are.
    const auto told = [&](const Diagnosis& diagnosis) {
        const bool as_warning = report([&](RunReport& r) { r.warnings.push_back(diagnosis); });
        EXPECT_EQ(as_warning, report([&](RunReport& r) { r.diagnosis = diagnosis; })) << diagnosis;
        EXPECT_EQ(as_warning,
                  refused([&](Restart& r) { r = {}, r.ended = true, r.position.report.diagnosis = diagnosis; }));
        return as_warning;
    };
    EXPECT_FALSE(told({DiagnosisKind::ground_jump, 1, {1}, {0.1}}));
    EXPECT_TRUE(told({DiagnosisKind::ground_jump, 2, {1}, {0.1}}));
    EXPECT_TRUE(told({DiagnosisKind::ground_jump, -1, {1}, {0.1}}));
    EXPECT_TRUE(told({DiagnosisKind::ground_jump, 1, {2}, {0.1}}));
    EXPECT_TRUE(told({DiagnosisKind::ground_jump, 1, {-1}, {0.1}}));
    EXPECT_TRUE(told({DiagnosisKind::ground_jump, 1, {}, {0.1}}));
    EXPECT_TRUE(told({DiagnosisKind::ground_jump, 1, {1}, {}}));
    EXPECT_TRUE(told({static_cast<DiagnosisKind>(200), 1, {1}, {0.1}}));
    EXPECT_TRUE(at([](RunPosition& p) { p.frames = -1; }));
    EXPECT_TRUE(at([](RunPosition& p) { p.multiples = huge; }));
    EXPECT_TRUE(refused([](Restart& r) { r.history_rows = -1; }));
    EXPECT_TRUE(state([](State& s) { s.stage = 2; }));
    EXPECT_TRUE(state([](State& s) { s.stage = -1; }));
    EXPECT_TRUE(state([](State& s) { s.grid = huge; }));
    EXPECT_TRUE(state([](State& s) { s.stage_time = 1e6; }));
    EXPECT_TRUE(state([](State& s) { s.next_time_step = -1; }));
    EXPECT_TRUE(state([](State& s) { s.coordinates.pop_back(); }));
    EXPECT_TRUE(state([](State& s) { s.velocities.clear(); }));
    EXPECT_TRUE(state([](State& s) { s.foundation_anchors.clear(); }));
    EXPECT_TRUE(state([](State& s) { s.boundary_reactions.push_back(0); }));
    EXPECT_TRUE(state([](State& s) { s.branch_strains.push_back(0); }));
    EXPECT_TRUE(state([](State& s) { s.contacts.patches.push_back({.point_count = huge_int}); }));
    EXPECT_TRUE(state([](State& s) { s.contacts.patches.push_back({.block_b = 2}); }));
    EXPECT_TRUE(state([](State& s) { s.planar_contacts.patches.push_back({.block_b = 1, .part_a = 1}); }));
    // Joints are judged by the planes of their faces: none may be beyond those that the stones have.
    const auto faces = [](std::uint32_t a, std::uint32_t b) {
        return [=](State& s) {
            s.contacts.patches.push_back({.block_b = 1, .feature_a = a, .feature_b = b});
            s.planar_contacts.patches.push_back({.block_b = 1, .feature_a = a, .feature_b = b});
        };
    };
    EXPECT_TRUE(state(faces(1U << 30U, 0)));
    EXPECT_TRUE(state(faces(0, 6)));
    const auto in_static = [&](auto change) {
        return refused([&](Restart& r) { r.state.stage = 0, change(r.position); });
    };
    EXPECT_FALSE(in_static([](RunPosition&) {}));
    EXPECT_TRUE(in_static([](RunPosition& p) { p.static_steps = huge_int; }));
    EXPECT_TRUE(in_static([](RunPosition& p) { p.load_increments = huge_int; }));
}

TEST_P(ResumedDraft, ASoundOneIsTakenOver)
{
    EXPECT_EQ(refusal_of([](DraftResults&) {}), "");
}

TEST_P(ResumedDraft, EditsAtRandomAreRefusedOrHarmless)
{
    Damage damage(1999);
    std::size_t refused = 0;
    constexpr std::size_t tried = 100;
    for (std::size_t i = 0; i < tried; ++i) {
        std::string bytes(3 + damage.below(12), '\0');
        for (char& byte : bytes) byte = static_cast<char>(damage.below(256));
        refused += !refusal_of([&](DraftResults& draft) { edit(bytes, draft); }).empty();
    }
    std::printf("%zu of %zu edited files refused\n", refused, tried);
    EXPECT_GT(refused, tried / 4);
    EXPECT_LT(refused, tried);
}

TEST_P(ResumedDraft, FewerRowsOrOtherColumnsThanTheRestartCountsAreRefused)
{
    const auto with = [&](const char* name, Extents extents) {
        return refusal_of([&](DraftResults& draft) {
            DraftDataset& data = draft.numbers.at(name);
            data.extents = extents;
            std::uint64_t count = 1;
            for (const std::uint64_t size : extents) count *= size;
            data.values.assign(count, 0);
        });
    };
    EXPECT_NE(with("/frames/energy", {2, 3}), "");
    EXPECT_NE(with("/frames/report", {1, 8}), "");
    EXPECT_NE(with("/frames/positions", {2}), "");
    EXPECT_NE(with("/frames/contacts/rows", {2, 1}), "");
    EXPECT_NE(with("/frames/contacts/rows", {2}), "");
    EXPECT_NE(with("/histories/values", {2, 3}), "");
    EXPECT_NE(with("/histories/values", {1, 9}), "");
    for (const double odd : {-1.0, 3.0, 9e18}) {
        const auto rows = [&](std::size_t at) {
            return refusal_of(
                [&](DraftResults& draft) { draft.numbers.at("/frames/contacts/rows").values[at] = odd; });
        };
        EXPECT_NE(rows(2), "") << odd;
        EXPECT_NE(rows(3), "") << odd;
    }
    Restart restart = sound_restart(the_case_);
    restart.position.frames = 3;
    EXPECT_NE(refusal_of(draft_of(the_case_), restart), "");
    restart = sound_restart(the_case_);
    restart.history_rows = std::int64_t{1} << 50;
    EXPECT_NE(refusal_of(draft_of(the_case_), restart), "");
}

}  // namespace voussoir::app::results
