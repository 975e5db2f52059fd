// Where the arches of a bridge stand, and what belongs to which of them.
#include <algorithm>

#include "importers/patterns/bridge_parts.h"

namespace voussoir::importers::patterns
{

double BridgeWork::left_end() const
{
    return to_nanometre(middles.front() - bridge.arches.front().span / 2 - bridge.abutment_length);
}

double BridgeWork::right_end() const
{
    return to_nanometre(middles.back() + bridge.arches.back().span / 2 + bridge.abutment_length);
}

double BridgeWork::pier_middle(int arch) const
{
    return to_nanometre(middles[arch] + (bridge.arches[arch].span + bridge.pier_width) / 2);
}

const Bay& BridgeWork::bay_of(int arch) const
{
    return *std::find_if(bays.begin(), bays.end(), [arch](const Bay& bay) { return arch < bay.end(); });
}

int BridgeWork::first_through() const
{
    int first = 0;
    for (const Bay& bay : bays) first = std::max(first, bay.profile.courses());
    return first;
}

int BridgeWork::backing_courses(const Bay& bay) const
{
    const BridgeProfile& profile = bay.profile;
    int courses = 0;
    while (courses < profile.crown_bed && profile.beds[courses + 1] <= profile.beds[0] + bridge.backing + 1e-6)
        ++courses;
    return courses;
}

std::pair<double, double> BridgeWork::reach(const Bay& bay, int region, int course) const
{
    if (course >= bay.profile.crown_bed) return {bay.left, bay.right};
    const double from_middle = bay.profile.end_of_course(course);  // < 0
    const int arch = bay.first + region;                           // behind the region
    return {region == 0 ? bay.left : middles[arch - 1] - from_middle,
            region == bay.arches ? bay.right : middles[arch] + from_middle};
}

}  // namespace voussoir::importers::patterns
