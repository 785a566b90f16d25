#pragma once
// This is `suturec diff OLD NEW`.

#include <string>
#include <vector>

namespace suture::compiler::driver {

/// Says what changed between two schema files or two folders of them. Only of folders it can tell
/// where a type that left a file is now. Returns the exit status: 0 if peers of the old
/// version still work, 1 if they do not, 2 if the question cannot be answered.
int diff(std::vector<std::string> arguments);

}  // namespace suture::compiler::driver
