// The table of docs/experiments.md on the thrown cube, line by line.
#pragma once

#include <string>
#include <vector>

#include "tests/verification/experiments/thrown_cube.h"

namespace voussoir::verification
{

void print_head();

/// Expects that every toss ran to its end. @returns the figures of the line
CubeFigures print_line(const std::string& name, const CubeSetting& setting, const std::vector<TossScore>& scores);

}  // namespace voussoir::verification
