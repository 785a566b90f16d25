#pragma once
// Every peer carries this: the fields of the paper's prmPositionCartesianGet, and numbers in bulk.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace peers {

struct Pose {
  std::array<double, 9> rotation{};  ///< row after row
  std::array<double, 3> position{};
  double timestamp = 0;
  bool valid = false;
  std::string frame, reference;

  bool operator==(const Pose&) const = default;
};

struct Blob {
  double timestamp = 0;
  std::vector<double> data;
};

/// Gives `pose` the values that belong to `number`; its strings keep their memory.
inline void fill(Pose& pose, std::uint64_t number) {
  const double angle = static_cast<double>(number % 1000) * 1e-3;
  const double cosine = 1 - angle * angle / 2;
  pose.rotation = {cosine, -angle, 0, angle, cosine, 0, 0, 0, 1};
  pose.position = {static_cast<double>(number), 0.25 + angle, -0.5 * angle};
  pose.timestamp = static_cast<double>(number + 1);
  pose.valid = true;
  pose.frame = "psm1";
  pose.reference = "ecm0";
}

}  // namespace peers
