#pragma once

#include <suture/base/time.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace robots {

/// Belongs to one thread; only the constructor allocates. Holds where something was in the last
/// cycles, in m in one frame. Stamps must ascend.
class MotionHistory {
 public:
  explicit MotionHistory(std::size_t cycles) : entries_(cycles) {}

  void add(suture::Time stamp, const Eigen::Vector3d& place) {
    entries_[count_++ % entries_.size()] = {stamp, place};
  }
  void clear() { count_ = 0; }

  /// Returns the last place at or before `stamp`; none if that is too long ago, or nothing is
  /// known.
  std::optional<Eigen::Vector3d> at(suture::Time stamp) const {
    const std::size_t kept = std::min(count_, entries_.size());
    for (std::size_t back = 1; back <= kept; ++back) {
      const Entry& entry = entries_[(count_ - back) % entries_.size()];
      if (entry.stamp <= stamp) return entry.place;
    }
    return std::nullopt;
  }

 private:
  struct Entry {
    suture::Time stamp;
    Eigen::Vector3d place;
  };
  std::vector<Entry> entries_;
  std::size_t count_ = 0;  // how many were ever added
};

}  // namespace robots
