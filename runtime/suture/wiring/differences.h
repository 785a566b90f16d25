#pragma once
// Why two contracts do not fit, field by field.

#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// Compares two self-descriptions (JSON). One line a difference: "commands.servo_cp.kind: 'write'
/// here, 'read' there". Documentation does not count. Empty: they say the same.
std::vector<std::string> differences(std::string_view here, std::string_view there);

}  // namespace suture
