#include "app/studies/verify/settings.h"

namespace voussoir::app::studies::verify
{

namespace
{

Kinematics planar_form(Kinematics spatial)
{
    return is_deformable(spatial) ? Kinematics::planar_deformable : Kinematics::planar_rigid;
}

}  // namespace

std::string method_name(const scenes::SceneSetting& setting)
{
    std::string name(name_of(setting.kinematics));
    name += setting.integrator == Integrator::newmark ? ", Newmark" : ", energy decaying";
    if (setting.papers_joints) name += ", joints as in the papers";
    if (setting.open_close == OpenClose::published) name += ", published iteration";
    if (setting.error_rate > 0) name += ", steps follow their error";
    return name;
}

std::vector<scenes::SceneSetting> standard_sweep(const std::vector<double>& time_steps,
                                                 const std::vector<double>& stiffness_factors)
{
    const scenes::SceneSetting rigid, newmark = as_in_papers({});
    scenes::SceneSetting deformable, published = newmark;
    deformable.kinematics = Kinematics::spatial_deformable;
    published.open_close = OpenClose::published;
    std::vector<scenes::SceneSetting> sweep;
    for (const scenes::SceneSetting& method : {rigid, deformable, newmark, published})
        for (const double step : time_steps) {
            sweep.push_back(method);
            sweep.back().time_step = step;
        }
    for (const double factor : stiffness_factors) {
        sweep.push_back(rigid);
        sweep.back().stiffness_factor = factor;
    }
    return sweep;
}

scenes::SceneSetting as_in_papers(scenes::SceneSetting setting)
{
    setting.integrator = Integrator::newmark;
    setting.papers_joints = true;
    return setting;
}

void add_planar(Benchmark& benchmark)
{
    benchmark.also = {planar_form(benchmark.setting.kinematics)};
}

void make_planar(Benchmark& benchmark, bool other_blocks)
{
    const bool deformable = is_deformable(benchmark.setting.kinematics);
    benchmark.also = {benchmark.setting.kinematics};
    if (other_blocks && deformable)
        benchmark.also.insert(benchmark.also.end(), {Kinematics::planar_rigid, Kinematics::spatial_rigid});
    if (other_blocks && !deformable)
        benchmark.also.insert(benchmark.also.end(),
                              {Kinematics::planar_deformable, Kinematics::spatial_deformable});
    benchmark.setting.kinematics = planar_form(benchmark.setting.kinematics);
    for (scenes::SceneSetting& setting : benchmark.sweep) setting.kinematics = planar_form(setting.kinematics);
}

std::vector<Benchmark> made_planar(std::vector<Benchmark> benchmarks, bool other_blocks)
{
    for (Benchmark& benchmark : benchmarks) make_planar(benchmark, other_blocks);
    return benchmarks;
}

std::vector<Benchmark> with_planar(std::vector<Benchmark> benchmarks)
{
    for (Benchmark& benchmark : benchmarks) add_planar(benchmark);
    return benchmarks;
}

}  // namespace voussoir::app::studies::verify
