#pragma once
// This says field by field why two contracts do not fit.

#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// Compares two self-descriptions (JSON). Returns one line for each difference:
/// "commands.servo_cp.kind: 'write' required, 'read' provided"; none if they say the same. Ignores
/// documentation. Both processes tell these lines, so "here" would say another end in each.
std::vector<std::string> differences(std::string_view required, std::string_view provided);

}  // namespace suture
