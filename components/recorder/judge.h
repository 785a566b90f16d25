#pragma once
// This decides from recordings if a slave did what the law asks of it. It fits no parameters: the
// path is the recorded master's, the times are the stamps that travelled with the data, the lag is
// the declared one.

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "recorder/followed_time.h"
#include "recorder/judging.h"
#include "recorder/recording.h"

namespace robots {

struct Judgement {
  ErrorSummary position;     ///< m, from where the slave should be by the goals that it received
  ErrorSummary orientation;  ///< rad, likewise
  /// The slave was off by this many m from where the law has it for the master at the same moment.
  /// That is no fault: data travel for a time and drives lag, so a slave is off by its speed times
  /// that delay.
  ErrorSummary equal_time;
  double speed_times_latency = 0;  ///< m: the mean of what explains the mean of equal_time
  double travel = 0;  ///< m: how far the slave got from where it was when following began
  FollowedShare followed;
  std::size_t compared = 0;  ///< slave cycles
  /// Counts the slave cycles whose master pose is not in the master's recording; they are not
  /// compared.
  std::size_t unmatched = 0;
};

/// A DeclaredLag is how a slave's drives trail its set-points by their own declaration, in s.
struct DeclaredLag {
  double time_constant = 0;  ///< 0: they go to each set-point at once
  /// This time passes from the measurement in a row until the set-point of that row acts. It is the
  /// period of drives that measure, and are told their next goal, once a cycle.
  double delay = 0;
};

/// Judges a slave while it is recorded, in memory that does not grow with its cycles. Rows must
/// come by ascending stamp, all on one clock. From the first announcement of the teleoperation on,
/// the law x_s = x_s0 + s V (x_m - x_m0), R_s = V R_m (V R_m0)^T R_s0, without what is locked,
/// gives the target of each slave cycle from the recorded master at the stamp of the set-point. A
/// first-order filter in Cartesian space with the declared lag gives where the slave should be.
/// Rate limits are not modelled: a slave that met one is late, and that is visible. While a slave
/// is not enabled the law asks for nothing, until following begins anew. The comparison at equal
/// time is made only while goals arrive, because a slave that is held has no latency.
///
/// A slave follows while it is enabled and gets new goals, however old their data are. One that
/// gets none has to stay where its last goal was, so its error says nothing of that.
class Judge {
 public:
  explicit Judge(const DeclaredLag& lag) : lag_(lag) {}

  void addMaster(const std::vector<ArmRow>& rows);
  void addFollowed(const std::vector<FollowAnchors>& followed);
  void addSlave(const std::vector<ArmRow>& rows);

  /// Judges every slave cycle whose master is known by now, and waits a while for records that come
  /// late.
  void advance();
  /// Returns the position error of what was judged since the last call; none if that is nothing.
  std::optional<ErrorSummary> recentPosition();
  /// Judges the rest, with or without its master.
  Judgement finish(const Duty& duty = {});

 private:
  struct Pose {
    Eigen::Vector3d p;
    Eigen::Quaterniond q;
  };

  /// This is a target and since when it acts.
  struct Acting {
    suture::Time since, stamp;  // stamp: of the master's pose from which it is computed
    Pose target;
    bool isNew;
  };

  using Entry = std::vector<FollowAnchors>::const_iterator;

  static Pose toPose(const Eigen::Isometry3d& pose);
  static Pose blend(const Pose& from, const Pose& to, double share);
  static Pose law(const FollowAnchors& anchors, const Pose& master);
  std::optional<Pose> masterAt(suture::Time stamp) const;
  Entry entryAfter(suture::Time stamp) const;
  std::optional<Pose> targetAt(suture::Time stamp) const;
  bool isFollowing(const ArmRow& row);
  bool getsGoals(const ArmRow& row);
  void judge(const ArmRow& row);
  void follow(const ArmRow& row, const Pose& measured);
  void compareAtEqualTime(const ArmRow& row, const Pose& measured, double latency);
  void moveExpected(suture::Time until);
  double shareIn(double seconds) const;
  void approach(const Pose& target, double seconds);
  void retarget(const ArmRow& row);
  void forgetMasterBefore(suture::Time stamp);

  const DeclaredLag lag_;
  std::deque<ArmRow> master_, waiting_;  // waiting_: the slave's
  suture::Time recordedUntil_;
  std::vector<FollowAnchors> followed_;
  std::deque<Acting> targets_;    // the first acts on the slave, the others will
  suture::Time targetStamp_;      // the latest target's
  std::optional<Pose> expected_;  // where the slave should be
  suture::Time last_;
  suture::Time goal_, gotGoal_;  // the stamp of the slave's last goal, and the cycle that got it
  FollowedTime followedTime_;
  std::optional<suture::Time> disabled_;  // the cycle since which the slave was last not enabled
  bool wasEnabled_ = true;
  std::optional<Eigen::Vector3d> start_;
  double travel_ = 0;
  std::size_t unmatched_ = 0;
  ErrorHistogram position_, orientation_;  // one error a cycle, m and rad
  ErrorHistogram recent_;                  // the errors of position that are not reported yet
  ErrorHistogram equalTime_, speedTimesLatency_;  // m, one each after a new target
};

/// Judges a whole run at once.
Judgement judge(const std::vector<ArmRow>& master, const std::vector<FollowAnchors>& followed,
                const std::vector<ArmRow>& slave, const DeclaredLag& lag);

struct JudgementBounds {
  double position = 0.001;          ///< m, at p99
  double orientation = 0.01745329;  ///< rad, at p99: one degree
  double travel = 0.03;             ///< m, at least
  double followed = 0.9;            ///< share of the time in which it had to follow, at least
  double unmatched = 0.05;  ///< share of cycles, at most: recorders do not stop at one instant
};

/// Returns each bound that is missed, in words; nothing if the slave kept all of them.
std::vector<std::string> violations(const Judgement& judgement, const JudgementBounds& bounds = {});

}  // namespace robots
