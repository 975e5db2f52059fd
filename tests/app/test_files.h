// Folders and case texts for the tests of case files.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/temporary_folder.h"

namespace voussoir::app
{

/// Two boxes, one on the other, at rest and then shaken: a case without faults. Line numbers matter to the tests.
inline const std::string two_boxes = R"(title: Two boxes
materials:
  granite: {density: 2400 kg/m3, young: 4.5 GPa, poisson: 0.25}
joints:
  dry: {friction: 30 deg}
blocks:
  - {box: {name: floor, lower: [-1, -1, -1], upper: [1, 1, 0]}, group: foundation}
  - {box: {name: stone, lower: [-0.5, -0.5, 0], upper: [50 cm, 0.5, 1]}}
foundation: {blocks: foundation}
stages:
  - {name: self-weight, type: static}
  - {name: shaking, type: dynamic, duration: 0.2 s, time_step: 2 ms}
output: {every: 20 ms, histories: {top: {block: stone}}}
)";

/// `text` with the first `old_part` replaced.
inline std::string with(std::string text, const std::string& old_part, const std::string& new_part)
{
    const std::size_t at = text.find(old_part);
    if (at == std::string::npos) throw std::logic_error("the test's text has no " + old_part);
    return text.replace(at, old_part.size(), new_part);
}

}  // namespace voussoir::app
