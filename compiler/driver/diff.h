#pragma once
// `suturec diff OLD NEW`.

#include <string>
#include <vector>

namespace suture::compiler::driver {

/// Says what changed between two schema files. The exit status: 0 if peers of the old version still
/// work, 1 if not, 2 if the question cannot be answered.
int diff(std::vector<std::string> arguments);

}  // namespace suture::compiler::driver
