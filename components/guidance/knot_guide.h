#pragma once
// This is the task that lets two masters place a knot with two slaves.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>
#include <suture/standard/message_port.h>

#include <chrono>

#include "guidance/fixtures.h"
#include "guidance/guidance.suture.h"
#include "guidance/guided_side.h"
#include "guidance/knot_estimate.h"
#include "pedals/foot_pedals.suture.h"
#include "pedals/operator_presence.suture.h"
#include "pedals/operator_watch.h"
#include "registration/registration.suture.h"
#include "teleop/preparation_limit.h"
#include "timing/cycle_watch.h"
#include "vision/knot_vision.suture.h"

namespace robots {

struct SUTURE_TYPE() GuideParameters {
  suture::Duration period = std::chrono::milliseconds(1);
  /// A slave moves this many metres for each metre of its master.
  SUTURE_FIELD(range(0.01, 10)) double scale = 0.4;
  /// If an arm's data are older than this, both slaves hold.
  suture::Duration max_age = std::chrono::milliseconds(20);
  /// What the cameras saw has the same kind of bound: some three images.
  suture::Duration sighting_age = std::chrono::milliseconds(250);
  /// Guiding does not begin with a registration that was renewed longer ago than this, and a
  /// sighting does not count if its camera was registered that long before it. Guiding goes on with
  /// the registration with which it began.
  suture::Duration registration_age = std::chrono::milliseconds(250);
  /// If pedals or presence are older than this, they are not known, and both slaves hold.
  suture::Duration operator_age = std::chrono::milliseconds(200);
  /// If it is true, the guide prepares and guides without waiting for enable().
  bool enable_at_start = true;
  /// If the arms and the registration are not ready after this time, the guide is disabled. With 0
  /// it waits for ever.
  suture::Duration preparation_limit = std::chrono::seconds(60);
  /// If it is false, the slaves follow their masters wherever the knot is.
  bool fixtures = true;
  /// The knot shall come here, in the scene.
  SUTURE_FIELD(unit("m")) Eigen::Vector3d target{0, 0, -0.15};
  /// It shall come there in this direction, of any length but zero.
  Eigen::Vector3d approach{0, 0, -1};
  /// The corridor has this radius at the target, and widens by this slope before that.
  SUTURE_FIELD(unit("m"), range(0.0001, 0.1)) double radius = 0.0003;
  SUTURE_FIELD(range(0, 1)) double slope = 0.3;
  /// A tip may move this fast along each axis.
  SUTURE_FIELD(unit("m/s"), range(0.001, 1)) double speed = 0.1;
  /// The tips may come this near to each other.
  SUTURE_FIELD(unit("m"), range(0, 0.1)) double separation = 0.01;
  /// Strand on strand has this coefficient of friction, by which the knot holds.
  SUTURE_FIELD(range(0, 1)) double friction = 0.15;
  /// The strand winds about itself by this angle in the knot.
  SUTURE_FIELD(unit("rad"), range(0, 100)) double wrap = 9.42;
  /// Each master presses against its hand with so much for each m/s that the fixtures forbid it,
  /// and floats in its hand while a pedal takes it from its slave. That is for a master that a hand
  /// moves and whose drives control efforts, because body_servo_cf ends every other stream. With 0
  /// the masters get no forces.
  SUTURE_FIELD(unit("N.s/m"), range(0, 1000)) double master_damping = 0;
};

/// Lets each slave follow its master by the law of teleoperation (teleop/follow_law.h), in the
/// directions that the surgeon sees (registration/surgeon_view.h), as far as the fixtures permit
/// (guidance/fixtures.h). If one arm's data are old, or the knot has not been seen lately, or the
/// surgeon is not there or presses a pedal that takes the masters, both slaves hold. Each time that
/// none of this is so any more they begin anew from where they are, once both carry out goals. They
/// also begin anew if a slave's set-point is not where the guide sent it, because the fixtures
/// judge where the tips are. What the fixtures forbid is made up for later only on the way to the
/// target. If a slave would refuse all further goals, it disables the guide.
class SUTURE_COMPONENT() KnotGuide final : public suture::PeriodicTask, public Guidance {
 public:
  /// Throws suture::SetupError for a line of approach without a direction, a scale that is not
  /// above zero, an age that is not, or is above a minute, or a limit of preparation that is
  /// neither 0 nor from 1 ms to a day.
  explicit KnotGuide(const GuideParameters& parameters);

  void enable() override;
  void disable() override;
  GuidanceState guidance_state() const override { return state_; }
  const GuidanceProgress& progress() const override { return progress_; }
  const ForbiddenMotion& forbidden_motion() const override { return forbidden_; }

  void run() override;
  /// A client that connects receives the first state too.
  void onStart() override { guidance_.emit().guidance_state(state_); }
  void onSuspend() override;
  void onResume() override;
  void onFault() override;

 private:
  void step();
  bool readScene();
  void forgetScene();
  bool readArms();
  bool read(GuidedSide& side);
  void lookForKnot();
  bool mustBeginAnew();
  bool begin();
  /// Returns false if a slave did not take its goal.
  bool move();
  Eigen::Vector3d knotOfTips() const;
  TipPair permitted(const TipPair& wish, const RoomPair& rooms);
  Eigen::Vector3d withoutHaste(const Eigen::Vector3d& wish) const;
  /// Lets the hands feel what the fixtures forbid of a wish, and forgets it.
  void forbid(const TipPair& forbidden);
  Eigen::Vector3d kept(const Eigen::Vector3d& wish, const Eigen::Vector3d& step) const;
  bool isRefused();
  void giveUp(const char* why);
  /// Stops following: both slaves hold.
  void leave(GuidanceState state);
  void enter(GuidanceState state);

  const GuideParameters parameters_;
  GuidedSide left_, right_;
  suture::Required<KnotVision> vision_{*this, "Vision"};
  suture::Required<Registration> registration_{*this, "Registration"};
  SUTURE_REQUIRED(optional()) suture::Required<FootPedals> pedals_{*this, "Pedals"};
  SUTURE_REQUIRED(optional()) suture::Required<OperatorPresence> presence_{*this, "Presence"};
  suture::Provided<Guidance> guidance_{*this, "Guidance", *this};
  suture::MessagePort messages_{*this};

  OperatorWatch operator_{pedals_, presence_, parameters_.operator_age};
  CycleWatch cycles_;
  PreparationLimit preparation_{parameters_.preparation_limit};
  KnotFixtures fixtures_;
  SceneFrames frames_;
  bool sceneIsKnown_ = false;  // at present, and not only from when guiding began
  TipPair setpoints_;          // where the slaves say that their tips shall be, in the scene
  TipPair tips_;               // where they have been sent, which setpoints_ reach within max_age
  KnotEstimate estimate_;
  GuidanceState state_ = GuidanceState::Disabled;
  bool enableAtFirstCycle_;
  bool offers_ = false;  // the slaves get their own set-points as goals
  GuidanceProgress progress_;
  ForbiddenMotion forbidden_;  // valid only while it guides
};

}  // namespace robots
