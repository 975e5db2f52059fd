#include "app/results/results_writer.h"

#include <algorithm>
#include <optional>
#include <system_error>

#include "app/results/atomic_file.h"
#include "app/results/frame_records.h"
#include "app/results/histories.h"
#include "app/results/model_records.h"
#include "app/results/summary.h"
#include "app/results/xdmf.h"

namespace voussoir
{

namespace
{

namespace fs = std::filesystem;

/// The pictures of a run, relative to its folder, in order.
std::vector<std::string> pictures_in(const fs::path& folder)
{
    std::vector<std::string> pictures;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "snapshots", none)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("snapshot_") && name.ends_with(".png")) pictures.push_back("snapshots/" + name);
    }
    std::sort(pictures.begin(), pictures.end());
    return pictures;
}

/// Makes the folder and removes what an earlier run left in it, so that no file speaks of another run.
fs::path prepare(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) refuse_writing(folder, error.value());
    for (const char* name : {"results.h5", "results.xdmf", "histories.csv", "summary.json"}) {
        fs::remove(folder / name, error);
        if (error) refuse_writing(folder / name, error.value());
    }
    for (const std::string& picture : pictures_in(folder)) fs::remove(folder / picture, error);
    return folder;
}

std::vector<std::string> files_in(const fs::path& folder)
{
    std::vector<std::string> files = {"results.h5", "results.xdmf"};
    if (fs::exists(folder / "histories.csv")) files.emplace_back("histories.csv");
    files.emplace_back("summary.json");
    const std::vector<std::string> pictures = pictures_in(folder);
    files.insert(files.end(), pictures.begin(), pictures.end());
    return files;
}

}  // namespace

struct ResultsWriter::Implementation {
    Implementation(const Case& a_case, const fs::path& a_folder)
        : the_case(a_case),
          folder(prepare(a_folder)),
          mesh(surface_mesh_of(a_case.model)),
          histories(a_case, folder / "histories.csv"),
          file(Hdf5File::create(folder / "results.h5"))
    {
        write_model_records(the_case, mesh, file);
        frames.emplace(the_case.model, file);
        if (!histories.columns.empty()) {
            file.make_group("/histories");
            history_rows = file.make_series("/histories/values", ElementType::float64, {histories.columns.size()});
            file.attribute("/histories/values", "columns", histories.columns);
        }
        file.flush();
    }

    void flush_histories()
    {
        if (histories.columns.empty()) return;
        const std::vector<double> values = histories.flush();
        file.append(history_rows, values, values.size() / histories.columns.size());
    }

    void close()
    {
        frames.reset();  // open datasets would keep the file open
        history_rows = {};
        file.close();
    }

    const Case& the_case;
    fs::path folder;
    SurfaceMesh mesh;
    Histories histories;
    Hdf5File file;
    std::optional<FrameRecords> frames;
    Hdf5Series history_rows;
};

ResultsWriter::ResultsWriter(const Case& the_case, const fs::path& folder)
    : implementation_(std::make_unique<Implementation>(the_case, folder))
{
}

ResultsWriter::~ResultsWriter() = default;

void ResultsWriter::frame(const State& state, const RunReport& report)
{
    Implementation& the = *implementation_;
    the.flush_histories();
    the.frames->append(the.the_case.model, the.mesh, state, report, the.file);
}

void ResultsWriter::history(const State& state, const StepReport&, const RunReport&)
{
    implementation_->histories.line(state);
}

void ResultsWriter::finish(const State& state, const RunReport& report, double wall_time, double cpu_time)
{
    Implementation& the = *implementation_;
    the.flush_histories();
    const std::string summary =
        summary_json(the.the_case, state, report, {wall_time, cpu_time}, files_in(the.folder));
    the.file.write_text("/summary", summary);
    the.close();
    write_xdmf(results_file(), the.folder / "results.xdmf");
    write_atomically(the.folder / "summary.json", summary);
}

fs::path ResultsWriter::results_file() const
{
    return implementation_->folder / "results.h5";
}

}  // namespace voussoir
