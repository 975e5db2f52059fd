#include "app/report/make_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "app/render/snapshots.h"
#include "app/report/diagrams.h"
#include "app/report/interactive_view.h"
#include "app/report/mechanism_words.h"
#include "app/report/pages.h"
#include "app/report/sections.h"
#include "app/results/own_folder.h"

namespace voussoir::app::report
{
namespace
{

namespace fs = std::filesystem;

/// "12.340 s", from the name of a picture, "snapshot_0001_t=12.340s".
std::string time_in(const std::string& name)
{
    const std::size_t at = name.find("t=");
    if (at == std::string::npos || name.empty()) return "unknown";
    return name.substr(at + 2, name.size() - at - 3) + " s";
}

/// The structure at the start of the motion, at the moment that is described, and at the end.
Section pictures_of(const RunRecord& record, const fs::path& folder)
{
    Section section{"Pictures", {}, {}, {}, {}, {}};
    SnapshotOptions options;
    options.width = 1280;
    options.height = 720;
    options.deformation_scale = visible_magnification(record);
    options.times = {record.course.times.front(), record.mechanism.time, record.course.times.back()};
    attempt(section, "There are no pictures", [&] {
        const std::vector<fs::path> pictures = render::render_snapshots(record.file, folder, options);
        for (const fs::path& picture : pictures) {
            const std::string name = picture.stem().string();
            section.pictures.push_back(
                {picture, "Displacement " +
                              results::counted_from(record.results.model, &picture != &pictures.front()) +
                              ", t = " + time_in(name) + "."});
        }
    });
    if (!is_deformable(record.results.model.kinematics)) return section;
    options.color = SnapshotColor::principal_stress;
    options.times = {record.course.times.back()};
    attempt(section, "There is no picture of the stresses", [&] {
        results::make_own_folder(folder / "stress");
        for (const fs::path& picture : render::render_snapshots(record.file, folder / "stress", options))
            section.pictures.push_back(
                {picture, "Largest compressive principal stress of each stone at the end."});
    });
    return section;
}

/// The film that the run has made, or a new one; a short run is slowed down to some six seconds.
Section film_of(const RunRecord& record, const fs::path& folder, const std::function<void(int, int)>& told)
{
    Section section{"Film", {}, {}, {}, {}, {}};
    const fs::path made = record.file.parent_path() / "video.mp4";
    std::error_code none;
    if (fs::exists(made, none) && fs::last_write_time(made, none) >= fs::last_write_time(record.file, none)) {
        section.pictures.push_back({made, "The film of the run.", true});
        return section;
    }
    const double duration = record.course.times.back() - record.course.times.front();
    if (!(duration > 0)) {
        section.paragraphs.emplace_back("No time passes in this run, so there is no film.");
        return section;
    }
    FilmOptions options;
    options.width = 960;
    options.height = 540;
    options.slow_down = std::clamp(std::round(6 / duration), 1.0, 1e4);
    options.deformation_scale = visible_magnification(record);
    attempt(section, "There is no film", [&] {
        render::request_film(record.file, folder / "film.mp4", options, told);
        section.pictures.push_back({folder / "film.mp4",
                                    options.slow_down > 1
                                        ? fmt::format("The run, slowed down {:g} times.", options.slow_down)
                                        : "The run in true time.",
                                    true});
    });
    return section;
}

/// The view, or why there is none.
Section view_of(const RunRecord& record, InteractiveView& view)
{
    Section section{"Interactive view", {}, {}, {}, {}, {}};
    view.script = view_script();
    if (view.script.text.empty()) {
        section.paragraphs.emplace_back(
            "There is none: this program was built without npm, which brings the library that draws it.");
        return section;
    }
    view.data = view_data(record, visible_magnification(record));
    section.has_view = !view.data.empty();
    section.paragraphs.emplace_back(
        section.has_view ? "The page report.html shows the stones as they moved, to be turned "
                           "and played. Joints open by more than 0.1 mm are red, those that slid are orange."
                         : "There is none: this structure has too many stones for one page.");
    return section;
}

Document document_of(const RunRecord& record, const fs::path& folder, bool film,
                     const std::function<void(int, int)>& told)
{
    Document document;
    document.title = record.results.model.title.empty() ? record.case_file : record.results.model.title;
    document.outcome = record.end.outcome.empty() ? "unfinished" : record.end.outcome;
    document.first_line = first_line_of(record);
    document.alarm = is_alarming(record);
    document.doubts = record.doubts;
    document.mechanism = name_of(record.mechanism.kind);
    document.mechanism_line = words_of(record.mechanism, record.results.model, record.course).headline;
    document.sections.push_back(key_results(record));
    document.sections.push_back(mechanism_section(record));
    document.sections.push_back(view_of(record, document.view));
    document.sections.push_back(pictures_of(record, folder));
    if (film) document.sections.push_back(film_of(record, folder, told));
    document.sections.push_back({"Histories", {}, {}, {}, {}, {}});
    document.sections.push_back(bars_section(record));
    document.sections.push_back(stones_and_joints(record));
    document.sections.push_back(what_was_analysed(record));
    document.sections.push_back(motion_section(record));
    document.sections.push_back(how_well_computed(record));
    document.sections.push_back(assumptions(record));
    document.sections.push_back(how_to_reproduce(record));
    add_diagrams(diagrams_of(record), folder, document.sections);
    drop_empty_sections(document);
    return document;
}

}  // namespace

std::vector<fs::path> make_report(const fs::path& results_file, const fs::path& folder, bool film,
                                  const std::function<void(int done, int all)>& told)
{
    const RunRecord record(fs::absolute(results_file));
    const fs::path companions = companions_folder(folder, "report");
    return write_document(document_of(record, companions, film, told), folder, "report");
}

}  // namespace voussoir::app::report
