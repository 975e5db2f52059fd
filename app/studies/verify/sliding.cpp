#include "app/studies/verify/sliding.h"

namespace voussoir::app::studies::verify
{
namespace
{

VerifyResult judge(EngineRun run, const History& reference, double paper_from)
{
    run.result.answer = answer_of(run.history);
    run.result.picture = picture_of(run.history, reference);
    run.result.error = worst_error(run.history, reference);
    run.result.paper_measure = worst_relative(run.history, reference, paper_from);
    return run.result;
}

}  // namespace

History reference_history(const references::SlidingProblem& problem, const std::vector<double>& times,
                          const ClosedForm& base)
{
    const std::vector<references::SlidingPoint> points = references::slide(problem, times);
    History reference;
    reference.times = times;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Eigen::Vector3d moved = base ? base(times[i]) : Eigen::Vector3d::Zero();
        const Eigen::Vector2d& slid = points[i].displacement;
        reference.displacements.push_back(moved + Eigen::Vector3d(slid.x(), slid.y(), 0));
    }
    return reference;
}

VerifyResult compare_sliding(const scenes::SlidingScene& scene, const scenes::SceneSetting& setting,
                             double paper_from, const ClosedForm& closed_form)
{
    EngineRun run = run_engine(scene, setting);
    History reference;
    for (const double time : run.history.times) reference.displacements.push_back(closed_form(time));
    return judge(std::move(run), reference, paper_from);
}

VerifyResult compare_sliding(const scenes::SlidingScene& scene, const scenes::SceneSetting& setting,
                             double paper_from, const references::SlidingProblem& problem, const ClosedForm& base)
{
    EngineRun run = run_engine(scene, setting);
    const History reference = reference_history(problem, run.history.times, base);
    return judge(std::move(run), reference, paper_from);
}

}  // namespace voussoir::app::studies::verify
