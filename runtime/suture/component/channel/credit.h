#pragma once
// This says which commands use credits.

#include <suture/component/contract/interface_info.h>

#include <cstdint>

namespace suture {

/// A newest-wins command without an answer travels in its cell, and uses no credit.
inline bool usesCredit(bool latest, std::uint32_t call) { return !latest || call != 0; }
inline bool usesCredit(const CommandInfo& command, std::uint32_t call) {
  return usesCredit(command.latest, call);
}

}  // namespace suture
