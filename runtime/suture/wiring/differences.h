#pragma once
// This says field by field why two contracts do not fit.

#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// Compares two self-descriptions (JSON). Returns one line for each difference:
/// "commands.servo_cp.kind: 'write' here, 'read' there"; none if they say the same. Ignores
/// documentation.
std::vector<std::string> differences(std::string_view here, std::string_view there);

}  // namespace suture
