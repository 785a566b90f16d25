#pragma once
// This is `suturec diff OLD NEW`.

#include <string>
#include <vector>

namespace suture::compiler::driver {

/// Says what changed between two schema files. Returns the exit status: 0 if peers of the old
/// version still work, 1 if they do not, 2 if the question cannot be answered.
int diff(std::vector<std::string> arguments);

}  // namespace suture::compiler::driver
