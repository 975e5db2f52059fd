#include "libdda/model/verdict.h"

namespace voussoir
{

std::string_view name_of(Standing standing)
{
    switch (standing) {
        case Standing::stands:
            return "stands";
        case Standing::moves:
            return "moves";
        case Standing::lost_stones:
            return "lost_stones";
        case Standing::fallen:
            return "fallen";
    }
    return "";
}

std::string_view name_of(DamageLevel damage)
{
    switch (damage) {
        case DamageLevel::none:
            return "none";
        case DamageLevel::limited_deformation:
            return "limited_deformation";
        case DamageLevel::light_damage:
            return "light_damage";
        case DamageLevel::significant_damage:
            return "significant_damage";
    }
    return "";
}

}  // namespace voussoir
