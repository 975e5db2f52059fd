#include "app/results/energy_terms.h"

namespace voussoir::app::results
{

std::vector<std::pair<std::string, double>> energy_terms(const EnergyLedger& energy)
{
    return {{"kinetic_J", energy.kinetic},
            {"strain_J", energy.strain},
            {"contact_J", energy.contact},
            {"gravity_work_J", energy.gravity_work},
            {"foundation_work_J", energy.foundation_work},
            {"boundary_work_J", energy.boundary_work},
            {"load_work_J", energy.load_work},
            {"friction_J", energy.friction},
            {"damping_kinetic_J", energy.damping_kinetic},
            {"damping_static_J", energy.damping_static},
            {"damping_contact_J", energy.damping_contact},
            {"damping_material_J", energy.damping_material},
            {"fracture_J", energy.fracture},
            {"yielding_J", energy.yielding},
            {"impact_J", energy.impact},
            {"closing_J", energy.closing},
            {"algorithmic_J", energy.algorithmic},
            {"algorithmic_rotation_J", energy.algorithmic_rotation},
            {"redetection_J", energy.redetection},
            {"start_kinetic_J", energy.start_kinetic},
            {"start_strain_J", energy.start_strain},
            {"start_contact_J", energy.start_contact},
            {"peak_stored_J", energy.peak_stored},
            {"peak_given_J", energy.peak_given},
            {"residual_J", energy.residual()}};
}

}  // namespace voussoir::app::results
