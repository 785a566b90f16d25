#pragma once
// Tests name the parts of the arm's contract with these numbers.

#include <suture/component/contract/interface_info.h>

#include <cstdint>

namespace reference {

inline constexpr std::uint16_t kServo = 0, kHold = 2, kSetMode = 3, kReset = 8, kLimit = 9;
inline constexpr std::uint16_t kMode = 0, kStopped = 2;
inline constexpr suture::EventSet kModeOnly = suture::EventSet{1} << kMode,
                                  kStoppedOnly = suture::EventSet{1} << kStopped;

}  // namespace reference
