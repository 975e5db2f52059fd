#include "app/results/growing_file.h"

#include <algorithm>
#include <numeric>
#include <system_error>
#include <type_traits>
#include <utility>

#include "app/results/counts.h"
#include "app/results/joint_rows.h"
#include "app/results/model_records.h"
#include "libdda/analysis/ground.h"
#include "libdda/errors.h"

namespace voussoir::app::results
{

namespace
{

constexpr std::uint64_t rows_at_once = 64;  // copied: a frame may be large

bool is_of_histories(const std::string& dataset)
{
    return dataset.starts_with("/histories/");
}

bool is_of_contacts(const std::string& dataset)
{
    return dataset.starts_with("/frames/contacts/") && dataset != "/frames/contacts/rows";
}

[[noreturn]] void refuse_rows(const std::filesystem::path& file, const std::string& dataset)
{
    throw InputError(file.string(), dataset + " does not have the expected number of rows", "start the run again");
}

/// Takes over the rows of one series after another.
struct Copy {
    const Hdf5File& from;
    std::filesystem::path from_path;
    Hdf5File& to;

    template <typename T>
    void rows(std::uint64_t count, Hdf5Series& series) const
    {
        std::uint64_t row = 1;
        for (std::size_t axis = 1; axis < series.extents.size(); ++axis) row *= series.extents[axis];
        // A dataset may claim more than was ever written: it would fill the disk.
        std::error_code none;
        if (count > std::filesystem::file_size(from_path, none) / std::max<std::uint64_t>(row, 1))
            refuse_rows(from_path, series.name);
        for (std::uint64_t first = 0; first < count; first += rows_at_once) {
            const std::uint64_t rows = std::min(rows_at_once, count - first);
            const std::vector<T> values = from.read_rows<T>(series.name, first, rows);
            if (values.size() != rows * row) refuse_rows(from_path, series.name);
            to.append(series, values, rows);
        }
    }
    void operator()(std::uint64_t count, Hdf5Series& series) const
    {
        switch (series.type) {
            case ElementType::float32:
                return rows<float>(count, series);
            case ElementType::float64:
                return rows<double>(count, series);
            case ElementType::int32:
                return rows<std::int32_t>(count, series);
            case ElementType::int64:
                return rows<std::int64_t>(count, series);
        }
    }
};

/// Puts values behind those that wait, which are of the same kind or none yet.
void add_values(const Rows& rows, RowValues& waiting)
{
    std::visit(
        [&](const auto& values) {
            using Values = std::decay_t<decltype(values)>;
            if (!std::holds_alternative<Values>(waiting)) waiting = Values();
            auto& all = std::get<Values>(waiting);
            all.insert(all.end(), values.begin(), values.end());
        },
        rows.values);
}

/// Whether the first row of a chunk is among so many rows from row `first` on.
bool begins_chunk(const Hdf5Series& series, std::uint64_t first, std::uint64_t count)
{
    const std::uint64_t next = (first + series.chunk_rows - 1) / series.chunk_rows * series.chunk_rows;
    return next < first + count;
}

/// 0, 1, 2, ..., as many as a frame has contacts or joints: results.xdmf makes cells of points with them.
void write_point_indices(std::size_t joints, Hdf5File& file)
{
    auto most = std::max<std::int64_t>(1, static_cast<std::int64_t>(joints));
    const auto rows = file.read<std::int64_t>("/frames/contacts/rows");
    for (std::size_t i = 1; i < rows.size(); i += 2) most = std::max(most, rows[i]);
    std::vector<std::int32_t> indices(static_cast<std::size_t>(most));
    std::iota(indices.begin(), indices.end(), 0);
    file.write("/frames/contacts/indices", indices);
}

/// Only of a structure on soil.
void write_soil(const Model& model, const std::vector<WatchedJoint>& joints, Hdf5File& file)
{
    const Foot foot(model, joints);
    if (!foot.is_on_soil()) return;
    std::vector<std::int32_t> soil;
    const std::vector<bool> is_ground = ground_marks(model);
    for (std::size_t b = 0; b < is_ground.size(); ++b)
        if (is_ground[b]) soil.push_back(static_cast<std::int32_t>(b));
    file.make_group("/model/soil");
    file.write("/model/soil/block", soil);
    file.write("/model/soil/foot", std::vector<std::int32_t>(foot.blocks().begin(), foot.blocks().end()));
}

}  // namespace

std::int64_t contact_rows_in(const std::filesystem::path& path, std::int64_t frames)
{
    if (frames <= 0) return 0;
    const std::string name = "/frames/contacts/rows";
    const Hdf5File file = Hdf5File::open(path);
    const auto last = file.read_rows<std::int64_t>(name, static_cast<std::uint64_t>(frames) - 1, 1);
    if (last.size() != 2 || !is_count(last[0]) || !is_count(last[1])) refuse_rows(path, name);
    return last[0] + last[1];
}

GrowingFile::GrowingFile(const std::filesystem::path& path, const Case& the_case, const SurfaceMesh& mesh,
                         const std::vector<WatchedJoint>& joints, const std::vector<GrowingDataset>& datasets)
    : file_(Hdf5File::create(path))
{
    write_model_records(the_case, mesh, file_);
    write_joints(the_case.model, joints, file_);
    write_soil(the_case.model, joints, file_);
    for (const GrowingDataset& dataset : datasets) {
        const std::string group = dataset.name.substr(0, dataset.name.rfind('/'));
        if (!file_.has(group)) file_.make_group(group);
        series_.push_back(file_.make_series(dataset.name, dataset.type, dataset.row, dataset.chunk_bytes));
        if (!dataset.columns.empty()) file_.attribute(dataset.name, "columns", dataset.columns);
    }
    waiting_.resize(series_.size());
    file_.write("/frames/count", std::vector<std::int64_t>{0});
}

std::size_t GrowingFile::series_named(const std::string& name) const
{
    const auto found = std::find_if(series_.begin(), series_.end(),
                                    [&](const Hdf5Series& series) { return series.name == name; });
    DDA_ASSERT(found != series_.end());
    return static_cast<std::size_t>(found - series_.begin());
}

void GrowingFile::copy(const CopiedRows& rows)
{
    const Hdf5File from = Hdf5File::open(rows.file);
    const Copy copy{from, rows.file, file_};
    const auto frames = static_cast<std::uint64_t>(rows.frames);
    const auto contacts = static_cast<std::uint64_t>(contact_rows_in(rows.file, rows.frames));
    for (Hdf5Series& series : series_) {
        std::uint64_t count = frames;
        if (is_of_histories(series.name)) count = static_cast<std::uint64_t>(rows.history_rows);
        if (is_of_contacts(series.name)) count = contacts;
        copy(count, series);
    }
}

void GrowingFile::append(const std::vector<Rows>& rows)
{
    // A chunk has its place in the file from its first row on. It is written at once, in the order of the frames,
    // so that the bytes of the file do not depend on how many of them came between two flushes.
    for (const Rows& each : rows) {
        const std::size_t index = series_named(each.name);
        const Hdf5Series& series = series_[index];
        const std::uint64_t before = series.extents[0] + waiting_[index].count;
        add_values(each, waiting_[index].values);
        waiting_[index].count += each.count;
        if (begins_chunk(series, before, each.count)) write_waiting(index);
    }
}

void GrowingFile::write_waiting(std::size_t index)
{
    const Waiting rows = std::exchange(waiting_[index], {});
    if (rows.count == 0) return;
    std::visit([&](const auto& values) { file_.append(series_[index], values, rows.count); }, rows.values);
}

void GrowingFile::write_waiting()
{
    for (std::size_t index = 0; index < series_.size(); ++index) write_waiting(index);
}

void GrowingFile::write_end(const std::string& summary, std::span<const JointPeaks> peaks)
{
    write_waiting();
    write_joint_peaks(peaks, file_);
    write_point_indices(peaks.size(), file_);
    file_.write_text("/summary", summary);
}

void GrowingFile::flush()
{
    write_waiting();
    const Hdf5Series& time = series_[series_named("/frames/time")];
    file_.overwrite("/frames/count", static_cast<std::int64_t>(time.extents[0]));
    file_.flush();
}

void GrowingFile::close()
{
    for (Hdf5Series& series : series_) file_.close(series);
    series_.clear();  // open datasets would keep the file open
    file_.close();
}

}  // namespace voussoir::app::results
