// What is said of judgements: a table for the terminal, JSON for programs.
#pragma once

#include <string>
#include <vector>

#include "app/problems/judge.h"
#include "app/problems/whole.h"

namespace voussoir::app::problems
{

/// The names of the columns. @param width of names
std::string head_line(int width);

/// One line: name, blocks, difference, iterations and CPU of both, verdict, tags, and why.
std::string line_of(const Judgement& judgement, int width);

/// "12 problems: 11 the same, 1 not unique, ...".
std::string summary_of(const std::vector<Judgement>& judgements);

/// All of it, every number in full.
std::string json_of(const std::vector<Judgement>& judgements, const JudgeOptions& options = {});

/// Lines of a comparison of two runs.
std::string lines_of(const WholeComparison& both);

}  // namespace voussoir::app::problems
