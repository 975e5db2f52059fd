#include "libdda/model/report.h"

#include <algorithm>
#include <cmath>

namespace voussoir
{

void EnergyLedger::note_peaks()
{
    peak_stored = std::max(peak_stored, kinetic + strain + contact);
    peak_taken = std::max(peak_taken, redetection);
    peak_given = std::max(peak_given, peak_taken - redetection);
}

double EnergyLedger::scale() const
{
    return std::max({std::abs(input()), dissipated(), peak_stored, start_kinetic + start_strain + start_contact});
}

double EnergyLedger::relative_residual() const
{
    const double whole = scale();
    return whole > 0 || std::isnan(residual()) ? std::abs(residual()) / whole : (residual() == 0 ? 0 : 1);
}

IterationCounts& IterationCounts::operator+=(const IterationCounts& other)
{
    relaxed += other.relaxed;
    whole_tangents += other.whole_tangents;
    shortened += other.shortened;
    return *this;
}

BlowCounts& BlowCounts::operator+=(const BlowCounts& other)
{
    solved += other.solved;
    unfinished += other.unfinished;
    return *this;
}

std::string_view name_of(Part part)
{
    switch (part) {
        case Part::contact_search:
            return "contact_search";
        case Part::assembly:
            return "assembly";
        case Part::linear_solve:
            return "linear_solve";
        case Part::open_close:
            return "open_close";
        case Part::update:
            return "update";
        case Part::output:
            return "output";
        case Part::count:
            break;
    }
    return "none";
}

std::string_view name_of(Outcome outcome)
{
    switch (outcome) {
        case Outcome::completed:
            return "completed";
        case Outcome::collapsed:
            return "collapsed";
        case Outcome::gave_up:
            return "gave_up";
        case Outcome::undecided:
            return "undecided";
        case Outcome::interrupted:
            return "interrupted";
    }
    return "none";
}

}  // namespace voussoir
