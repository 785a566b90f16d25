#pragma once
// These are two ends that were built from the same contract at different times.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// Says how well two ends that speak over a wire understand each other's contracts.
struct Compatibility {
  /// False: one of them says nothing of the wire, so nothing is known.
  bool comparable = true;
  /// These are the numbers of the commands here that are not there.
  std::vector<std::uint16_t> lacking;
  /// Each line says what one would misread of the other: "'x' of struct Pose: Float64 unit "m"
  /// here, Float32 there". If it is empty they understand each other; each ignores what only the
  /// other has.
  std::vector<std::string> breaks;
};

/// Compares what two self-descriptions (JSON) say of the wire, as `suturec diff` does with locks.
/// It is not for two ends that share memory.
Compatibility compatibility(std::string_view here, std::string_view there);

}  // namespace suture
