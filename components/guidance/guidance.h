#pragma once
// This is the contract of a guide, which says what it is doing, and how far the knot is from its
// target.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <Eigen/Core>
#include <cstdint>

namespace robots {

enum class SUTURE_TYPE() GuidanceState : std::uint8_t {
  Preparing,  ///< waits for the registration, and for all four arms: connected, enabled, homed,
              ///< fresh data of each, and slaves that take goals
  Blind,      ///< the arms are ready, but nobody has seen the knot lately; both slaves hold
  Guiding,
  Disabled,  ///< until enable(); also since a slave refused its goals for a reason that stays
  Clutched,  ///< a pedal takes the masters from their slaves, or nobody is at the console: both
             ///< slaves hold, and the masters are the surgeon's to move
};

struct SUTURE_TYPE() GuidanceProgress {
  /// The knot is here by the last sighting and by what the tips have moved since, in the scene.
  SUTURE_FIELD(unit("m")) Eigen::Vector3d knot = Eigen::Vector3d::Zero();
  /// The knot has this distance to go along the line of approach; it is below zero behind the
  /// target.
  SUTURE_FIELD(unit("m")) double distance_to_target = 0;
  /// The knot has this distance from the line of approach.
  SUTURE_FIELD(unit("m")) double lateral_error = 0;
  /// The stamp is that of the guide's cycle.
  suture::Time stamp;
  /// This is false unless the knot has been seen lately.
  bool valid = false;
};

/// Says how fast the hands lead each tip where the fixtures let none go, in the scene: what a hand
/// should feel of them. What a fixture only delays is not in it.
struct SUTURE_TYPE() ForbiddenMotion {
  SUTURE_FIELD(unit("m/s")) Eigen::Vector3d left = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("m/s")) Eigen::Vector3d right = Eigen::Vector3d::Zero();
  /// The stamp is that of the guide's cycle.
  suture::Time stamp;
  /// This is false while the guide does not guide.
  bool valid = false;
};

/// Commands run in the guide's own thread before its next cycle; reads are from the end of its last
/// one.
class SUTURE_INTERFACE() Guidance {
 public:
  virtual ~Guidance() = default;

  /// Enables and homes arms that are not, then guides. This also works after an arm was disabled or
  /// restarted. It does not enable an arm in FAULT: the operator who has removed the cause does.
  SUTURE_COMMAND() virtual void enable() = 0;
  /// Stops guiding. Both slaves hold.
  SUTURE_COMMAND() virtual void disable() = 0;

  SUTURE_COMMAND() virtual GuidanceState guidance_state() const = 0;
  /// The guide updates this even while it waits for something, as far as the knot has been seen.
  SUTURE_COMMAND() virtual const GuidanceProgress& progress() const = 0;
  /// A client at the masters makes hands feel this, as components/force_feedback says.
  SUTURE_COMMAND() virtual const ForbiddenMotion& forbidden_motion() const = 0;

  /// Reports each change, and the last one to a client that connects.
  SUTURE_EVENT(latched(), name("guidance_state"))
  suture::EventOf<GuidanceState> guidance_state_event;
};

}  // namespace robots
