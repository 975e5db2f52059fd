#include "app/results/growing_file.h"

#include <algorithm>

#include "app/results/model_records.h"
#include "libdda/errors.h"

namespace voussoir
{

namespace
{

constexpr std::uint64_t rows_at_once = 64;  // copied: a frame may be large

bool is_of_histories(const std::string& dataset)
{
    return dataset.starts_with("/histories/");
}

bool is_of_joints(const std::string& dataset)
{
    return dataset.starts_with("/frames/joints/") && dataset != "/frames/joints/rows";
}

template <typename T>
void copy_series(const Hdf5File& from, std::uint64_t count, Hdf5File& file, Hdf5Series& series)
{
    for (std::uint64_t first = 0; first < count; first += rows_at_once) {
        const std::uint64_t rows = std::min(rows_at_once, count - first);
        file.append(series, from.read_rows<T>(series.name, first, rows), rows);
    }
}

void copy_series(const Hdf5File& from, std::uint64_t count, Hdf5File& file, Hdf5Series& series)
{
    switch (series.type) {
        case ElementType::float32:
            return copy_series<float>(from, count, file, series);
        case ElementType::float64:
            return copy_series<double>(from, count, file, series);
        case ElementType::int32:
            return copy_series<std::int32_t>(from, count, file, series);
        case ElementType::int64:
            return copy_series<std::int64_t>(from, count, file, series);
    }
}

}  // namespace

GrowingFile::GrowingFile(const std::filesystem::path& path, const Case& the_case, const SurfaceMesh& mesh,
                         const std::vector<GrowingDataset>& datasets)
    : file_(Hdf5File::create(path))
{
    write_model_records(the_case, mesh, file_);
    for (const GrowingDataset& dataset : datasets) {
        const std::string group = dataset.name.substr(0, dataset.name.rfind('/'));
        if (!file_.has(group)) file_.make_group(group);
        series_.push_back(file_.make_series(dataset.name, dataset.type, dataset.row));
        if (!dataset.columns.empty()) file_.attribute(dataset.name, "columns", dataset.columns);
    }
    file_.write("/frames/count", std::vector<std::int64_t>{0});
}

Hdf5Series& GrowingFile::series_named(const std::string& name)
{
    const auto found = std::find_if(series_.begin(), series_.end(),
                                    [&](const Hdf5Series& series) { return series.name == name; });
    DDA_ASSERT(found != series_.end());
    return *found;
}

void GrowingFile::copy(const CopiedRows& rows)
{
    const Hdf5File from = Hdf5File::open(rows.file);
    const auto frames = static_cast<std::uint64_t>(rows.frames);
    std::uint64_t joints = 0;
    if (frames > 0) {
        const auto last = from.read_rows<std::int64_t>("/frames/joints/rows", frames - 1, 1);
        joints = static_cast<std::uint64_t>(last[0] + last[1]);
    }
    for (Hdf5Series& series : series_) {
        std::uint64_t count = frames;
        if (is_of_histories(series.name)) count = static_cast<std::uint64_t>(rows.history_rows);
        if (is_of_joints(series.name)) count = joints;
        copy_series(from, count, file_, series);
    }
}

void GrowingFile::append(const std::vector<Rows>& rows)
{
    for (const Rows& each : rows)
        std::visit([&](const auto& values) { file_.append(series_named(each.name), values, each.count); },
                   each.values);
}

void GrowingFile::write_summary(const std::string& text)
{
    file_.write_text("/summary", text);
}

void GrowingFile::flush()
{
    file_.overwrite("/frames/count", static_cast<std::int64_t>(series_named("/frames/time").extents[0]));
    file_.flush();
}

void GrowingFile::close()
{
    series_.clear();  // open datasets would keep the file open
    file_.close();
}

}  // namespace voussoir
