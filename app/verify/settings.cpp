#include "app/verify/settings.h"

namespace voussoir
{

std::string method_name(const VerifySetting& setting)
{
    std::string name(name_of(setting.kinematics));
    name += setting.integrator == Integrator::newmark ? ", Newmark" : ", energy decaying";
    if (setting.open_close == OpenClose::published) name += ", published iteration";
    return name;
}

std::vector<VerifySetting> standard_sweep(const std::vector<double>& time_steps,
                                          const std::vector<double>& stiffness_factors)
{
    VerifySetting rigid, deformable, decaying, published;
    deformable.kinematics = Kinematics::spatial_deformable;
    decaying.integrator = Integrator::energy_decaying;
    published.open_close = OpenClose::published;
    std::vector<VerifySetting> sweep;
    for (const VerifySetting& method : {rigid, deformable, decaying, published})
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

}  // namespace voussoir
