// `--set stages[1].time_step="1 ms"`: values changed from the command line.
#pragma once

#include <string>
#include <vector>

#include "app/reader/findings.h"
#include "app/reader/yaml_tree.h"

namespace voussoir::app::reader
{

/// Puts `key=value` into the tree: the key is a path of names and list positions ("stages[1].time_step"), the
/// value is YAML. Missing keys are created; the position after a list's last appends; the value `null` takes the
/// key away. What cannot be done is a fault placed at "--set stages[1].time_step".
void apply_override(const std::string& setting, YamlNode& root, Findings& findings);

}  // namespace voussoir::app::reader
