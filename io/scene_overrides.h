// Command-line overrides ("--set key=value") laid into the tree of a scene before it is read, so
// that they pass the same checks as the file. Entries of arrays are addressed by name.
#pragma once

#include "io/toml_reader.h"

namespace quern {

// Gives every species and wall without a name its default one.
void give_names(Node& root);

// What cannot be placed is reported; the rest is in the tree, marked with its override.
void apply_overrides(Node& root, const std::vector<std::string>& overrides, Messages& messages);

}  // namespace quern
