#pragma once
// These are the commands that set an arm in motion and must be repeated: rates, twists and forces.

#include <suture/base/time.h>

#include <optional>
#include <string_view>

#include "arm_control/motion/rate_ramp.h"
#include "drives/motor_order.h"
#include "kinematics/inverse.h"
#include "kinematics/spatial_vector.h"
#include "timing/stream_watch.h"

namespace robots {

/// One thread; never allocates. Holds what the last of servo_jv, servo_jf, servo_cv, servo_cf and
/// free() asks of the set-point.
template <int N>
class MotionStream {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;
  using SpatialVector = kinematics::SpatialVector;
  using Mask = Eigen::Array<bool, N, 1>;
  enum class Kind {
    None,
    Free,
    JointRate,
    BodyTwist,
    SpatialTwist,
    JointEffort,
    BodyWrench,
    SpatialWrench
  };

  /// Releases the joints and lets the set-point follow them. Here and below, `activity` is a text
  /// of static storage by which the arm says what it does meanwhile.
  void release(std::string_view activity);
  /// Bounds a rate, which is in rad/s or m/s.
  struct JointBounds {
    typename RateRamp<N>::Limits change = {};
    /// Holds the positions that no joint passes; a joint that has reached its own stays there.
    std::optional<Joints> guard = {};
  };
  void follow(const Joints& rate, std::string_view activity, const JointBounds& bounds = {});
  /// Bounds a twist of the tip, which is along its own axes (BodyTwist) or those of the base
  /// (SpatialTwist).
  struct TwistBounds {
    /// The twist and these limits are along axes that `axes` rotates to those of the tip
    /// (BodyTwist) or of the base (SpatialTwist).
    RateRamp<6>::Limits change = {};
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  };
  void follow(Kind kind, const SpatialVector& twist, std::string_view activity,
              const TwistBounds& bounds);
  /// Says what the motors give, in N.m or N. The joints outside of `released` are held.
  void push(const Joints& effort, const Mask& released, std::string_view activity);
  /// Says with which wrench the tip presses, along its own axes (BodyWrench) or those of the base
  /// (SpatialWrench). All joints are released.
  void push(Kind kind, const SpatialVector& wrench, std::string_view activity);
  void end();

  bool isActive() const { return kind_ != Kind::None; }
  /// Returns true if it moves the tip, and not single joints.
  bool isOfTip() const { return isWrench() || isTwist(); }
  std::string_view activity() const { return activity_; }

  /// Call this once a cycle. Returns true if the stream has been silent for too long. free() needs
  /// no repetition.
  bool hasFallenSilent(suture::Time now) { return watch_.hasFallenSilent(now); }

  /// A Step is a set-point within the limits of the joints.
  struct Step {
    Joints q;
    bool limited = false;  ///< it would lie beyond the limits, and slides along them
  };
  /// Returns the set-point `dt` seconds after `setpoint`; none if no joint vector reaches it.
  std::optional<Step> next(const kinematics::Chain<N>& chain,
                           kinematics::InverseFunction<N> inverse, const Joints& setpoint,
                           const Joints& measured, double dt);
  /// Returns what the motors of joints at `measured` do. If a wrench asks a motor for more than
  /// `most`, all efforts shrink by one factor, so that it keeps its direction; of efforts of single
  /// joints only those that are too large shrink.
  MotorOrder<N> motors(const kinematics::Chain<N>& chain, const Joints& measured,
                       const Joints& most) const;

 private:
  bool isTwist() const { return kind_ == Kind::BodyTwist || kind_ == Kind::SpatialTwist; }
  bool isWrench() const { return kind_ == Kind::BodyWrench || kind_ == Kind::SpatialWrench; }
  void begin(Kind kind, std::string_view activity);
  Joints nextByRate(const Joints& setpoint, double dt);
  std::optional<Step> nextByTwist(const kinematics::Chain<N>& chain,
                                  kinematics::InverseFunction<N> inverse, const Joints& setpoint,
                                  double dt);

  Kind kind_ = Kind::None;
  std::string_view activity_;
  RateRamp<N> rate_;
  std::optional<Joints> guard_;
  RateRamp<6> twist_;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  MotorOrder<N> order_;  // its efforts are those of JointEffort
  SpatialVector wrench_ = SpatialVector::Zero();
  StreamWatch watch_;
};

extern template class MotionStream<6>;
extern template class MotionStream<7>;

}  // namespace robots
