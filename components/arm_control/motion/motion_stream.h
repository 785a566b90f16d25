#pragma once
// The commands that set an arm in motion and have to be repeated: rates, twists and forces.

#include <suture/base/time.h>

#include <optional>
#include <string_view>

#include "arm_control/motion/rate_ramp.h"
#include "kinematics/inverse.h"
#include "kinematics/spatial_vector.h"
#include "timing/stream_watch.h"

namespace robots {

/// What the last of servo_jv, servo_jf, servo_cv, servo_cf and free() asks of the set-point.
/// Confined to one thread; never allocates.
template <int N>
class MotionStream {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;
  using SpatialVector = kinematics::SpatialVector;
  enum class Kind { None, Free, JointRate, BodyTwist, SpatialTwist };

  /// Activities are of static storage: what the arm says that it does meanwhile.
  void beFree(std::string_view activity) { begin(Kind::Free, activity); }
  /// rad/s or m/s
  struct JointBounds {
    typename RateRamp<N>::Limits change = {};
    /// The positions that a joint does not pass; one that is there stays.
    std::optional<Joints> guard = {};
  };
  void follow(const Joints& rate, std::string_view activity, const JointBounds& bounds = {});
  /// A twist of the tip along its own axes (BodyTwist) or the base's (SpatialTwist).
  struct TwistBounds {
    /// Along `axes`, which lead from those of the twist to the base's.
    RateRamp<6>::Limits change = {};
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  };
  void follow(Kind kind, const SpatialVector& twist, std::string_view activity,
              const TwistBounds& bounds);
  void end();

  bool isActive() const { return kind_ != Kind::None; }
  /// It moves the tip, not single joints.
  bool isOfTip() const { return kind_ == Kind::BodyTwist || kind_ == Kind::SpatialTwist; }
  std::string_view activity() const { return activity_; }

  /// Counts a cycle; true: the stream has been silent for too long. free() needs no repeating.
  bool hasFallenSilent(suture::Time now) { return watch_.hasFallenSilent(now); }

  /// A set-point within the limits of the joints.
  struct Step {
    Joints q;
    bool limited = false;  ///< it would lie beyond them, and slides along them
  };
  /// The set-point `dt` seconds after `setpoint`; none if no joint vector reaches it.
  std::optional<Step> next(const kinematics::Chain<N>& chain,
                           kinematics::InverseFunction<N> inverse, const Joints& setpoint,
                           const Joints& measured, double dt);

 private:
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
  StreamWatch watch_;
};

extern template class MotionStream<6>;
extern template class MotionStream<7>;

}  // namespace robots
