#pragma once
// This is `suturec diff OLD NEW`.

#include <string>
#include <vector>

namespace suture::compiler::driver {

/// Prints what changed between two schema files, or between two folders of them. Between folders it
/// also finds a type that has moved from one file to another. Returns the exit status: 0 if peers
/// of the old version still work, 1 if they do not, 2 if the question cannot be answered.
int diff(std::vector<std::string> arguments);

}  // namespace suture::compiler::driver
