#include "app/results/results_writer.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "app/results/atomic_file.h"
#include "app/results/frame_rows.h"
#include "app/results/histories.h"
#include "app/results/own_folder.h"
#include "app/results/results_reader.h"
#include "app/results/summary.h"
#include "app/results/twin_files.h"
#include "app/results/xdmf.h"
#include "libdda/errors.h"

namespace voussoir::app::results
{

namespace
{

namespace fs = std::filesystem;

/// The pictures of a run, relative to its folder, in order.
std::vector<std::string> pictures_in(const fs::path& folder)
{
    std::vector<std::string> pictures;
    if (!is_own_folder(folder / "snapshots")) return pictures;  // a link: the pictures are not ours
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "snapshots", none)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("snapshot_") && name.ends_with(".png")) pictures.push_back("snapshots/" + name);
    }
    std::sort(pictures.begin(), pictures.end());
    return pictures;
}

void remove_files(const fs::path& folder, const std::vector<std::string>& names)
{
    for (const std::string& name : names) {
        std::error_code error;
        fs::remove(folder / name, error);
        if (error) refuse_writing(folder / name, error.value());
    }
}

/// Makes the folder and removes what an earlier run left in it, so that no file speaks of another run.
void prepare(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) refuse_writing(folder, error.value());
    remove_files(folder, {restart_file_in({}), "results.h5", "results.xdmf", "histories.csv", "summary.json"});
    remove_files(folder, {"video.mp4", "video.gif", "video.webp", "report.html", "report.md", "report.json"});
    remove_files(folder, pictures_in(folder));
}

CopiedRows rows_of(const fs::path& results, const Restart& restart)
{
    TwinFiles::restore_name(results);
    const ResultsReader reader(results);
    if (reader.times.size() < static_cast<std::size_t>(restart.position.frames))
        throw InputError(results.string(), "fewer frames than the run had written", "start the run again");
    return {results, restart.position.frames, restart.history_rows};
}

std::vector<std::string> files_in(const fs::path& folder)
{
    std::vector<std::string> files = {"results.h5", "results.xdmf"};
    std::error_code none;
    if (fs::exists(folder / "histories.csv", none)) files.emplace_back("histories.csv");
    files.emplace_back("summary.json");
    if (fs::exists(restart_file_in(folder), none)) files.push_back(restart_file_in({}));
    const std::vector<std::string> pictures = pictures_in(folder);
    files.insert(files.end(), pictures.begin(), pictures.end());
    return files;
}

}  // namespace

struct ResultsWriter::Implementation {
    Implementation(const Case& a_case, const fs::path& a_folder, const Restart* from)
        : the_case(a_case),
          folder(a_folder),
          mesh(surface_mesh_of(a_case.model)),
          joints(joints_at_start(a_case.model, initial_state(a_case.model))),
          rest{.foot = {a_case.model, joints}, .coordinates = {}},
          histories(a_case, rest.foot)
    {
        std::optional<CopiedRows> begin_with;
        if (from)
            begin_with = rows_of(results(), *from);
        else
            prepare(folder);
        twins.emplace(results(), the_case, mesh, joints, datasets(), begin_with);
        restart.computed_from = fingerprint_of(the_case);
        std::vector<double> lines;
        if (from) {
            read_back(*from, lines);
            remove_files(folder, {"results.xdmf", "summary.json"});  // of the moment of the interruption
        }
        histories.create(folder / "histories.csv", lines);
    }

    fs::path results() const { return folder / "results.h5"; }

    std::vector<GrowingDataset> datasets() const
    {
        std::vector<GrowingDataset> datasets = frame_datasets(the_case.model, mesh, joints);
        if (!histories.columns.empty())
            datasets.push_back(
                {"/histories/values", ElementType::float64, {histories.columns.size()}, histories.columns});
        return datasets;
    }

    /// What is counted on from where the restart stands.
    void read_back(const Restart& from, std::vector<double>& lines)
    {
        restart.history_rows = from.history_rows;
        restart.remarks = from.remarks;
        rest.is_over = !from.position.reference.empty();
        rest.coordinates = rest.is_over ? from.position.reference : from.state.coordinates;
        if (rest.is_over) count_from(the_case.model, rest.coordinates, joints);
        restart.trust = from.trust;
        contact_rows = contact_rows_in(results(), from.position.frames);
        if (!histories.columns.empty())
            lines = Hdf5File::open(results()).read_rows<double>("/histories/values", 0,
                                                                static_cast<std::uint64_t>(from.history_rows));
    }

    /// The last frame before the first motion is what displacements count from.
    void see_rest(const State& state)
    {
        const auto stage = static_cast<std::size_t>(state.stage);
        const bool was_over = rest.is_over;
        rest.is_over = was_over || (stage < the_case.stages.size() && the_case.stages[stage].moves());
        if (!rest.is_over) rest.coordinates = state.coordinates;
        if (rest.is_over && !was_over && !rest.coordinates.empty())
            count_from(the_case.model, rest.coordinates, joints);
    }

    /// The lines of histories since the last call wait for the next store().
    void add_histories()
    {
        std::vector<double> values = histories.take();
        if (values.empty()) return;
        const std::uint64_t rows = values.size() / histories.columns.size();
        restart.history_rows += static_cast<std::int64_t>(rows);
        twins->add({{"/histories/values", std::move(values), rows}});
    }
    /// What waits is in the files.
    void store()
    {
        histories.flush();
        twins->store();
    }

    const Case& the_case;
    fs::path folder;
    SurfaceMesh mesh;
    std::vector<WatchedJoint> joints;  // of the start
    Rest rest;
    Histories histories;
    std::optional<TwinFiles> twins;
    std::int64_t contact_rows = 0;  // in the tables of contacts
    Restart restart;                // as it was saved last
    std::optional<ErrorEstimate> estimate;
};

ResultsWriter::ResultsWriter(const Case& the_case, const fs::path& folder)
    : implementation_(std::make_unique<Implementation>(the_case, folder, nullptr))
{
}

ResultsWriter::ResultsWriter(const Case& the_case, const fs::path& folder, const Restart& restart)
    : implementation_(std::make_unique<Implementation>(the_case, folder, &restart))
{
}

ResultsWriter::~ResultsWriter() = default;

void ResultsWriter::frame(const State& state, const RunReport& report)
{
    add_frame(state, report);
    implementation_->store();
}

void ResultsWriter::add_frame(const State& state, const RunReport& report)
{
    Implementation& the = *implementation_;
    the.add_histories();
    the.see_rest(state);
    the.twins->add(
        frame_rows(the.the_case.model, the.mesh, the.joints, the.rest, state, report, the.contact_rows));
}

bool ResultsWriter::is_full() const
{
    constexpr std::size_t much = std::size_t{32} << 20;  // bytes; twice as much is there while it is stored
    return implementation_->twins->held_bytes() + implementation_->histories.held_bytes() > much;
}

void ResultsWriter::history(const State& state, const StepReport&, const RunReport&)
{
    implementation_->histories.line(state);
}

void ResultsWriter::save(const State& state, const RunPosition& position, const CommandTimes& times)
{
    Implementation& the = *implementation_;
    the.add_histories();
    the.store();
    the.restart.state = state;
    the.restart.position = position;
    the.restart.wall_time = times.wall;
    the.restart.cpu_time = times.cpu;
    save_restart(the.restart, restart_file_in(the.folder));
}

void ResultsWriter::note(const TrustStart& trust)
{
    implementation_->restart.trust = trust;
}

void ResultsWriter::note(const ErrorEstimate& estimate)
{
    implementation_->estimate = estimate;
}

std::vector<JointPeaks> ResultsWriter::finish(const State& state, const RunReport& report,
                                              const CommandTimes& times)
{
    Implementation& the = *implementation_;
    the.add_histories();
    the.histories.flush();
    the.see_rest(state);
    RunReport last = report;
    if (last.joints.size() != the.joints.size()) last.joints = no_peaks(the.joints);
    note_joints(the.the_case.model, the.joints, state, last);
    RunQuality quality;
    if (the.restart.trust)
        quality.trust =
            trust_in(*the.restart.trust, as_begun(the.the_case.stages, last.shorter_steps), last.energy);
    quality.estimate = the.estimate;
    const std::string summary =
        summary_json(the.the_case, the.joints, state, last, quality, times, files_in(the.folder));
    the.twins->finish(summary, last.joints);
    write_xdmf(results_file(), the.folder / "results.xdmf");
    write_atomically(the.folder / "summary.json", summary);
    return last.joints;
}

void ResultsWriter::end(const RunReport& report)
{
    Restart& restart = implementation_->restart;
    restart.ended = true;
    restart.state = {};
    restart.position.report = report;
    save_restart(restart, restart_file_in(implementation_->folder));
}

fs::path ResultsWriter::results_file() const
{
    return implementation_->results();
}

}  // namespace voussoir::app::results
