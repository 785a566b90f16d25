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
  /// These are the numbers of the required commands that are not provided.
  std::vector<std::uint16_t> lacking;
  /// Each line says what one would misread of the other: "'x' of struct Pose: Float64 unit "m"
  /// required, Float32 provided". If it is empty they understand each other; each ignores what only
  /// the other has.
  std::vector<std::string> breaks;
};

/// Compares what two self-descriptions (JSON) say of the wire, as `suturec diff` does with locks.
/// It is not for two ends that share memory.
Compatibility compatibility(std::string_view required, std::string_view provided);

}  // namespace suture
