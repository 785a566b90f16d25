#pragma once
// The contract of a guide: what it is doing, and how far the knot is from its target.

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
  /// Where the knot is by the last sighting and by what the tips have moved since; in the scene.
  SUTURE_FIELD(unit("m")) Eigen::Vector3d knot = Eigen::Vector3d::Zero();
  /// Along the line of approach; below zero behind the target.
  SUTURE_FIELD(unit("m")) double distance_to_target = 0;
  /// From the line of approach.
  SUTURE_FIELD(unit("m")) double lateral_error = 0;
  /// The guide's cycle.
  suture::Time stamp;
  /// False unless the knot has been seen lately.
  bool valid = false;
};

/// Commands run in the guide's own thread before its next cycle; reads are from the end of its last
/// one.
class SUTURE_INTERFACE() Guidance {
 public:
  virtual ~Guidance() = default;

  /// Enables and homes arms that are not, then guides. Also after an arm was disabled or restarted.
  /// An arm in FAULT is not enabled: whoever has removed the cause enables it.
  SUTURE_COMMAND() virtual void enable() = 0;
  /// Stops guiding; both slaves hold.
  SUTURE_COMMAND() virtual void disable() = 0;

  SUTURE_COMMAND() virtual GuidanceState guidance_state() const = 0;
  /// It is told also while the guide waits for something, as far as the knot has been seen.
  SUTURE_COMMAND() virtual const GuidanceProgress& progress() const = 0;

  /// Each change, and the last one to whoever connects.
  SUTURE_EVENT(latched(), name("guidance_state"))
  suture::EventOf<GuidanceState> guidance_state_event;
};

}  // namespace robots
