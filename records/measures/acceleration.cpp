#include "records/measures/acceleration.h"

#include <cmath>

#include "libdda/errors.h"
#include "records/units.h"

namespace voussoir::records::measures
{

Channel even_acceleration(const Channel& channel, const std::string& measure)
{
    const std::string place = measure + " of component \"" + channel.component + "\"";
    if (!has_unit(channel))
        throw InputError(place, "samples of an unknown unit", "give the record a unit: " + known_units());
    if (channel.quantity != Quantity::acceleration)
        throw InputError(place, std::string("samples of ") + to_text(channel.quantity),
                         "differentiate it to an acceleration first");
    Channel even = resampled_evenly(channel);
    if (even.samples.size() < 2 || !(even.time_step > 0))
        throw InputError(place, std::to_string(even.samples.size()) + " samples",
                         "at least 2 samples and a time step");
    return even;
}

}  // namespace voussoir::records::measures
