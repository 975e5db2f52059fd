// Ties, clamps and dowels: what they carried, of what they can, and how they are left.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/course.h"
#include "app/report/document.h"

namespace voussoir::app::results
{
class Hdf5File;
}

namespace voussoir::app::report
{

struct RunRecord;

/// The ways in which a bar can yield.
enum class BarForce { tension, compression, shear };

/// A bar over a run.
struct BarCourse {
    std::string name;
    std::int32_t block_a = 0, block_b = 0;
    bool is_rod = true;
    double strength[3] = {};              // N, by BarForce; infinite: elastic
    Peak force[3];                        // N, the same; the time is that of a stored frame, NaN: not stored
    Peak elongation;                      // m
    std::vector<double> tension, shear;   // N, of the frames; empty in results of earlier versions
    double last_force[2] = {};            // N, tension and shear at the end
    double last_elongation = 0;           // m
    double yielded = 0;                   // m, for good, at the end
    std::optional<double> yielded_since;  // s
    std::optional<double> out_since;      // s, a dowel that left its hole

    /// The way in which it came closest to yielding.
    BarForce governing() const;
    /// Of its strength, in that way; nothing: it has no strength that is known.
    std::optional<double> use() const;
    /// When that was [s]; NaN: not known.
    double when() const;
};

/// All bars of a run; none in a scene without. @param summary JSON text, "{}" of a run that was killed
std::vector<BarCourse> bars_of(const results::Hdf5File& file, const std::vector<double>& times,
                               const std::string& summary);

/// "tension", "compression", "shear".
const char* name_of(BarForce force);

/// Those first that came closest to yielding.
std::vector<const BarCourse*> by_use(const std::vector<BarCourse>& bars);

/// The chapter on bars; nothing in it in a scene without.
Section bars_section(const RunRecord& record);

/// The bar that came closest to yielding, as a row of key results; empty in a scene without.
std::vector<std::string> bar_row(const RunRecord& record);

/// Bars of the same name side by side.
Section bars_compared(const RunRecord& a, const RunRecord& b);

/// The title of that chapter, where its diagrams belong.
constexpr const char* bars_title = "Ties, clamps and dowels";

}  // namespace voussoir::app::report
