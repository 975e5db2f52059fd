#include "libdda/limit/standing.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "libdda/contact/find_contacts.h"

namespace voussoir::limit
{

namespace
{

template <int D>
void find_near(const Model& model, double reach, State& state)
{
    std::vector<double> reaches(model.blocks.size());
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
        reaches[b] = std::max(reach, contact::contact_distance) * size_of(model, static_cast<int>(b)) +
                     model.fit_tolerance / 2;
    contact::SearchMemory<D> search;
    ContactSetIn<D> contacts;
    contact::find_contacts(model, state, reaches, 1, search, contacts, contact::NewOverlap::drawn);
    contacts_in<D>(state) = std::move(contacts);
}

}  // namespace

LimitProblem problem_in(const Model& model, const State& state, const Eigen::Vector3d& dead,
                        const Eigen::Vector3d& live, double reach, FacePoints points)
{
    State near = state;
    if (is_planar(model.kinematics))
        find_near<2>(model, reach, near);
    else
        find_near<3>(model, reach, near);
    return limit_problem_of(model, near, dead, live, reach, points);
}

Balance balance_in(const Model& model, const State& state, const Eigen::Vector3d& gravity, double reach)
{
    if (!is_known_to_limit_analysis(model)) return {};
    return balance_of(problem_in(model, state, gravity, Eigen::Vector3d::Zero(), reach, FacePoints::corners));
}

Standing sliding_in(const Model& model, const State& state, const Eigen::Vector3d& gravity, double reach,
                    const std::vector<int>& moving)
{
    if (!is_known_to_limit_analysis(model)) return Standing::unknown;
    LimitProblem problem = problem_in(model, state, gravity, Eigen::Vector3d::Zero(), reach, FacePoints::all);
    if (!moving.empty())
        for (std::size_t b = 0; b < problem.blocks.size(); ++b)
            if (!std::binary_search(moving.begin(), moving.end(), static_cast<int>(b))) problem.blocks[b].hold();
    return standing_without_dilatancy(problem);
}

}  // namespace voussoir::limit
