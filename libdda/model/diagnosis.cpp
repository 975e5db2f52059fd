#include "libdda/model/diagnosis.h"

#include <algorithm>
#include <array>
#include <ostream>

#include "libdda/errors.h"

namespace voussoir
{

namespace
{

DiagnosisForm cut_to_the_least(std::string_view name)
{
    return {name, true, 0, 1, {"time_s", "cuts", "min_time_step_s", "unbalanced"}};
}

DiagnosisForm make_form(DiagnosisKind kind)
{
    switch (kind) {
        case DiagnosisKind::interrupted:
            return {"interrupted", false, 0, 0, {}};
        case DiagnosisKind::fallen:
            return {"fallen", false, 1, 0, {"time_s"}};
        case DiagnosisKind::inverted_block:
            return cut_to_the_least("inverted_block");
        case DiagnosisKind::singular_system:
            return cut_to_the_least("singular_system");
        case DiagnosisKind::inaccurate_solution:
            return cut_to_the_least("inaccurate_solution");
        case DiagnosisKind::chatter:
            return cut_to_the_least("chatter");
        case DiagnosisKind::unbalanced:
            return cut_to_the_least("unbalanced");
        case DiagnosisKind::too_many_cuts:
            return {"too_many_cuts", true, 0, 1, {"time_s", "time_step_s", "cut_steps", "last_step_s"}};
        case DiagnosisKind::no_equilibrium:
            return {"no_equilibrium", true, 0, 0, {"steps", "unbalanced"}};
        case DiagnosisKind::mechanism:
            return {"mechanism", true, 1, 0, {"moved_m", "direction_x", "direction_y", "direction_z"}};
        case DiagnosisKind::undecided:
            return {"undecided", true, 0, 0, {"time_step_s", "end", "second_time_step_s", "second_end"}};
        case DiagnosisKind::deep_overlap:
            return {"deep_overlap",
                    true,
                    2,
                    2,
                    {"time_s", "depth_m", "share", "forgiven_m", "overlap_time_s", "drawn_m"}};
        case DiagnosisKind::no_number:
            return {"no_number", true, 1, 1, {"time_s"}};
        case DiagnosisKind::energy_no_number:
            return {"energy_no_number", true, 1, 1, {"time_s"}};
        case DiagnosisKind::energy_from_nowhere:
            return {"energy_from_nowhere", true, 1, 1, {"time_s", "share", "speed_m_s"}};
        case DiagnosisKind::energy_vanished:
            return {"energy_vanished", true, 1, 1, {"time_s", "share", "speed_m_s"}};
        case DiagnosisKind::energy_from_contacts:
            return {"energy_from_contacts", true, 0, 0, {"time_s", "share"}};
        case DiagnosisKind::energy_unaccounted:
            return {"energy_unaccounted", false, 0, 0, {"share"}};
        case DiagnosisKind::energy_given:
            return {"energy_given", false, 0, 0, {"share"}};
        case DiagnosisKind::overlap:
            return {"overlap", false, 2, 2, {"depth_m", "share", "forgiven_m", "overlap_time_s", "drawn_m"}};
        case DiagnosisKind::ground_jump:
            return {"ground_jump", true, 1, 1, {"velocity_jump_m_s"}};
        case DiagnosisKind::dry_joints:
            return {"dry_joints", false, 2, 2, {"joints", "widest_gap_m"}};
        case DiagnosisKind::crushed_joints:
            return {"crushed_joints",
                    false,
                    2,
                    2,
                    {"joints", "stress_to_strength", "time_s", "duration_s", "brief_joints"}};
        case DiagnosisKind::friction_open:
            return {"friction_open", true, 0, 0, {"end", "balanced"}};
    }
    return {};
}

}  // namespace

const DiagnosisForm& form_of(DiagnosisKind kind)
{
    static const auto forms = [] {
        std::array<DiagnosisForm, diagnosis_kinds> made;
        for (int k = 0; k < diagnosis_kinds; ++k) made[k] = make_form(static_cast<DiagnosisKind>(k));
        return made;
    }();
    return forms[static_cast<int>(kind)];
}

double value_of(const Diagnosis& diagnosis, std::string_view name)
{
    const std::vector<std::string_view>& names = form_of(diagnosis.kind).values;
    const auto found = std::find(names.begin(), names.end(), name);
    DDA_ASSERT(found != names.end());
    return diagnosis.values[found - names.begin()];
}

bool is_whole(const Diagnosis& diagnosis)
{
    if (static_cast<int>(diagnosis.kind) >= diagnosis_kinds) return false;
    const DiagnosisForm& form = form_of(diagnosis.kind);
    if (diagnosis.stage < -1 || (diagnosis.stage >= 0) != form.has_stage) return false;
    if (diagnosis.blocks.size() < form.fewest_blocks) return false;
    if (diagnosis.kind == DiagnosisKind::fallen || diagnosis.kind == DiagnosisKind::mechanism)
        return diagnosis.values.size() == diagnosis.blocks.size() * form.values.size();
    return diagnosis.blocks.size() <= form.blocks && diagnosis.values.size() == form.values.size();
}

std::ostream& operator<<(std::ostream& stream, const Diagnosis& diagnosis)
{
    const DiagnosisForm& form = form_of(diagnosis.kind);
    stream << form.name << ":";
    if (diagnosis.stage >= 0) stream << " stage " << diagnosis.stage << ",";
    stream << " blocks";
    for (const int block : diagnosis.blocks) stream << " " << block;
    for (std::size_t i = 0; i < diagnosis.values.size(); ++i)
        stream << ", " << form.values[i % form.values.size()] << " " << diagnosis.values[i];
    return stream;
}

}  // namespace voussoir
