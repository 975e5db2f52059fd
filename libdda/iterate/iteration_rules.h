// Every number of the open-close iteration.
#pragma once

#include <cstddef>

namespace voussoir::step
{

/// How a line search looks for the place where what the forces do along a direction has halved.
struct SearchRule {
    int most_evaluations = 0;
    double least_part = 0;  // of the bracket, that regula falsi must take off: else it is halved
    int halved_every = 1;   // so many evaluations, whatever regula falsi says
};

/// What the iteration goes by. A step is accepted by its residual alone. Where it has one solution none of this
/// moves it by more than the tolerance; on the way to rest, where friction leaves several, it may decide which is
/// found. Source: docs/numerics.md 3.
struct IterationRules {
    // A change of state of so few contacts is a matter of all stones, more are first a matter of single ones.
    std::size_t few_changes = 8;        // points
    double few_changes_of_all = 0.005;  // and this share of them

    // Linear systems are solved to this share of what the step still asks for, within two bounds.
    double linear_share = 0.5;
    double finest = 1e-2, coarsest = 0.1;  // of the residual
    int most_vectors = 50;                 // of a Krylov space

    // Of the way of all stones a small part is worth no direction; a single one is often stopped at a millionth.
    SearchRule of_all{12, 0.1, 12}, of_one{9, 0, 3};

    // Stones relaxed one by one.
    double worth_relaxing = 0.02;  // of the worst unbalance: stones with less are left alone
    int sweeps = 40;               // at most
    double few_stones = 0.2;       // of all: so many may be due in a sweep beyond the first two
    // Few rows are due in most sweeps, near one another: domains are small, so that they lie in several.
    int rows_in_domain = 32;  // some; fewer rows that are due stay on one thread
    int most_domains = 1024;  // some
};

}  // namespace voussoir::step
