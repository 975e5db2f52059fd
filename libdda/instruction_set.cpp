#include "libdda/instruction_set.h"

namespace voussoir
{

std::string_view instruction_set()
{
#if defined(__AVX2__) && defined(__FMA__)
    return "x86-64-v3";
#elif defined(__x86_64__)
    return "x86-64";
#else
    return "native";
#endif
}

}  // namespace voussoir
