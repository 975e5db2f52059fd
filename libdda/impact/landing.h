// Stones that land: the impulses by which approaching stones meet.
//
// Springs alone answer an impact as the time step, their stiffness and the integrator make them: a stiff contact
// that closes in the middle of a step leaves the stones with a speed between the negative and the positive of what
// they had. Here the landing is found before the step, when and where it happens, and answered by Newton's law:
// the normal speed afterwards is `restitution` times the approach speed. Closed joints pass impulses on; a joint
// that stays closed loses nothing. The springs of the step then see the flight after the impact. Source:
// docs/method.md, "Landing".
#pragma once

#include <optional>
#include <vector>

#include "libdda/impact/impulses.h"
#include "libdda/problem/step_problem.h"

namespace voussoir::step
{

/// A contact point and the patch that it is of, as indices into a contact set.
struct ClosingPoint {
    int point = 0, patch = 0;
};

/// The stones that land in a step of length h. All references must outlive it.
template <class K>
class Landings
{
 public:
    using Vector = typename K::Vector;
    using Spin = typename K::Spin;
    static constexpr int D = K::dimension;

    Landings(const Model& model, const Stage& stage, const State& state, const ContactSetIn<D>& contacts,
             double h);

    /// Finds what lands in straight flight.
    /// @returns the jumps of the stones, in ascending order of the block; none where nothing lands
    std::vector<Jump<K>> find();
    /// Lets points land besides that close in the step, whatever a straight flight says: the impulses go on from
    /// those found so far. @returns the jumps by all of them
    std::vector<Jump<K>> find_also(const std::vector<ClosingPoint>& missed);

 private:
    struct Blow {
        double fraction = 1;  // of the step
        double approach = 0;  // m/s, of the fastest landing
    };
    void add(const ClosingPoint& closing, double approach);
    double approach_of(const ClosingPoint& closing);
    std::vector<Jump<K>> solve();
    std::vector<Blow> blows() const;
    std::vector<double> ground_works() const;

    const Model& model_;
    const ContactSetIn<D>& contacts_;
    double h_;     // s
    double slow_;  // m/s: slower landings are left to the springs
    Impulses<K> impulses_;
};

/// The part of a step that may be done before the first of the jumps, so that what presses until then does so for
/// as long as it does [s]; nothing where they are all at its start, or slower than gravity makes
/// a stone in a step. @param h of the step [s]
template <class K>
std::optional<double> step_to_landing(const Stage& stage, const std::vector<Jump<K>>& jumps, double h);

/// The points that closed in a converged step although a straight flight did not bring their stones together, and
/// that were approaching fast enough for a landing: forces bent their way. In ascending order of the point.
template <class K>
std::vector<ClosingPoint> missed_landings(const Model& model, const Stage& stage, const State& state,
                                          const ContactSetIn<K::dimension>& contacts,
                                          const StepProblem<K>& problem);

}  // namespace voussoir::step
