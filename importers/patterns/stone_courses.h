// A rectangular body of masonry, laid in courses of boxes in bond.
#pragma once

#include <string>
#include <utility>

#include "importers/patterns/facade.h"
#include "importers/patterns/pattern.h"

namespace voussoir::importers::patterns
{

/// All lengths in m.
struct CoursedBody {
    std::string name, group;            // its stones are NAME_c01_b01, ...
    std::pair<double, double> x, y, z;  // from, to
    BlockFormat block;
};

/// Adds equal courses of about a block's height. Along x joints lie about a block's length apart, half of that off
/// in every second course. Stones reach through a body up to one and a half lengths wide; in a wider one they lie
/// in rows along x, with joints between the rows likewise and those in them half a length off in every second row.
/// @pre all extents are > 0
void add_courses(Pattern& pattern, const CoursedBody& body);

/// Adds the body as one course. @param number of the course, from 1
void add_course(Pattern& pattern, const CoursedBody& body, int number);

}  // namespace voussoir::importers::patterns
