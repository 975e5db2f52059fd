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

    /// Whether a point has landed, at first or in a blow that followed others in the step.
    bool has_landed(const ClosingPoint& closing) const;

    const BlowCounts& counts() const { return counts_; }

 private:
    /// A point at which stones come together after a blow of the same step.
    struct Closing {
        ClosingPoint at;
        double fraction = 0;  // of the step, when
        double approach = 0;  // m/s
    };
    void add(const Closing& closing, Impulses<K>& impulses);
    double approach_of(const ClosingPoint& closing);
    void solve(Impulses<K>& impulses);
    std::vector<Jump<K>> jumps();
    void follow(std::vector<Jump<K>>& jumps, std::vector<double> times);
    std::vector<Closing> look_for_more(Impulses<K>& impulses, double fastest) const;

    const Model& model_;
    const ContactSetIn<D>& contacts_;
    double h_;                 // s
    double slow_;              // m/s: slower landings are left to the springs
    Impulses<K> impulses_;     // of the first blows
    BlowCounts counts_;        // of all
    int blow_ = 1;             // that is being solved, of those that follow one another
    std::vector<int> landed_;  // by point: in which of them it landed last, 0: in none
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
