// The engine says for which machines it was compiled, and is the one that was asked for.
#include <cstdio>
#include <string>

#include "libdda/instruction_set.h"

/// @param arguments[1] the instruction set that the build was told to use
int main(int argument_count, char** arguments)
{
    const std::string found(voussoir::instruction_set());
    std::printf("the engine is for %s\n", found.c_str());
    return argument_count == 2 && found == arguments[1] ? 0 : 1;
}
