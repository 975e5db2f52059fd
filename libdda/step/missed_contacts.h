// Contacts that a step should have known of: blocks that moved farther than expected, through something.
#pragma once

#include <vector>

#include "libdda/contact/find_contacts.h"
#include "libdda/problem/step_problem.h"
#include "libdda/step/reach.h"

namespace voussoir::step
{

/// Whether two blocks end the step within one another that had no contact in it. Only where a block moved beyond
/// its reach, which a static step under gravity may do (its velocity is taken, its h is long), are contacts looked
/// for again, as far as the blocks went; motions are linear in between.
/// @param extents (blocks); @param reach (blocks) [m] that `contacts` were found with
template <class K>
bool misses_a_contact(const Model& model, const State& state, const StepProblem<K>& problem,
                      const ContactSetIn<K::dimension>& contacts, const std::vector<Extent>& extents,
                      const std::vector<double>& reach, int threads);

}  // namespace voussoir::step
