// The verdict on a structure, in the same words everywhere.
#pragma once

#include <string>

#include "libdda/model/model.h"
#include "libdda/model/verdict.h"

namespace voussoir::app::words
{

/// One sentence: "The structure stands, undamaged: ...". What it counts is since the first motion began, relative
/// to the ground.
std::string in_words(const Verdict& verdict, const Model& model);

}  // namespace voussoir::app::words
