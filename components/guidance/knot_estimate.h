#pragma once
// This estimates where the knot is between two sightings.

#include <suture/base/time.h>

#include <Eigen/Core>
#include <optional>

#include "guidance/motion_history.h"

namespace robots {

/// Belongs to one thread; only the constructor allocates. Adds to the knot as it was seen by how
/// much the tips have moved since, because images come late and seldom. It keeps where the
/// sightings put the knot relative to the mean of the tips: that changes slowly, so it is smoothed,
/// and the movement is not. Points are in one frame, in m.
class KnotEstimate {
 public:
  /// A sighting counts for `age`; tipsAt() must be called once in each `period`.
  KnotEstimate(suture::Duration age, suture::Duration period)
      : age_(age), history_(static_cast<std::size_t>(age / period) + 2) {}

  /// Call this in each cycle, by ascending `now`, with where the mean of the tips is.
  void tipsAt(suture::Time now, const Eigen::Vector3d& mean) {
    tips_ = mean;
    history_.add(now, mean);
  }
  /// Says that the knot was seen at `knot` at the time `stamp`. The same sighting may be passed
  /// again; one from before the history begins is ignored.
  void seenAt(suture::Time stamp, const Eigen::Vector3d& knot) {
    if (offset_ && stamp == seen_) return;
    const auto mean = history_.at(stamp);
    if (!mean) return;
    const Eigen::Vector3d offset = knot - *mean;
    // An offset from before the knot was out of sight does not count, because the knot may have
    // moved meanwhile.
    const bool goesOn = offset_ && stamp - seen_ <= age_;
    offset_ = goesOn ? *offset_ + kShareOfNew * (offset - *offset_) : offset;
    seen_ = stamp;
  }
  void forget() {
    history_.clear();
    offset_.reset();
  }

  /// Returns where the knot is; none if it has not been seen lately.
  std::optional<Eigen::Vector3d> knot(suture::Time now) const {
    if (!offset_ || now - seen_ > age_) return std::nullopt;
    return tips_ + *offset_;
  }

 private:
  // With 15 sightings a second the estimate follows a change of the offset within half a second,
  // and the noise of the sightings is reduced to a third.
  static constexpr double kShareOfNew = 0.2;

  suture::Duration age_;
  MotionHistory history_;
  Eigen::Vector3d tips_ = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> offset_;  // where the knot is, seen from the tips' mean
  suture::Time seen_;
};

}  // namespace robots
