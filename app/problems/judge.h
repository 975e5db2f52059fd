// Judges the fast open-close iteration by the plain one, step by step.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/problems/measure.h"
#include "app/problems/problem.h"

namespace voussoir::app::problems
{

/// What is found of a problem.
enum class Verdict {
    same,          // both steps are one, or become one when they are solved more closely
    not_unique,    // they differ, and each obeys the laws
    plain_failed,  // the plain iteration did not make the step; of the fast one nothing can be said
    fast_failed,   // the fast one did not, the plain one did
    wrong,         // they differ, and one breaks a law
    lawful,        // too large for the plain iteration; the fast step obeys the laws
};

/// "the same", "not unique", ...
std::string_view name_of(Verdict verdict);

/// Of one problem.
struct Judgement {
    std::string name;
    int blocks = 0;
    std::vector<std::string> tags;
    Difference difference;
    StepReport fast, plain;
    double fast_seconds = 0, plain_seconds = 0;  // of CPU
    Verdict verdict = Verdict::same;
    std::string why;  // where they are not the same, in a few words
    // Where they differ by more than they may, and both obey the laws: the difference, in the same units, of steps
    // that are solved a hundred times as closely. If they come together they are the same, and badly conditioned.
    std::optional<double> closer;
};

/// How many times the tolerance two steps may differ that are the same.
constexpr double most_difference = 10;

/// One attempt at the step of a problem, with a workspace of its own. @param stage of the problem
MadeStep make_step(const Case& the_case, Stage stage, const StoredStep& problem, OpenClose open_close);

/// @param stage of the problem; @param fast, plain steps from its state
Judgement compare(const Case& the_case, const Stage& stage, const StoredStep& problem, const MadeStep& fast,
                  const MadeStep& plain);

/// How problems are judged.
struct JudgeOptions {
    int large_from = 0;        // blocks, from which the plain iteration is not asked; 0: it always is
    int iterations = 0;        // that the fast one may take; 0: as the case has them
    int most_in_all = 0;       // iterations that the fast one may take in all problems together; 0: any number
    int most_not_unique = -1;  // problems; -1: one in twenty
};

/// @throws InputError when the problem is not one of the case
Judgement judge(const Case& the_case, const StoredStep& problem, const JudgeOptions& options = {});

/// Iterations of the fast one, of all together. A tangent that lacks a term leads to the same step, by more of
/// them.
int fast_iterations(const std::vector<Judgement>& judgements);

/// Whether the fast iteration has passed: nothing is wrong, it fails nowhere alone, and neither the problems that
/// are not unique nor its iterations are more than they may be.
bool passes(const std::vector<Judgement>& judgements, const JudgeOptions& options = {});

}  // namespace voussoir::app::problems
