#pragma once
// This is an operator who looks at the picture, and carries a knot to its target with both hands.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>

#include "arm/arm.suture.h"
#include "arm/arm_watch.h"
#include "drives/rate_filter.h"
#include "force_feedback/fixture_resistance.h"
#include "force_feedback/position_position.h"
#include "guidance/guidance.suture.h"
#include "hand/hand.h"
#include "registration/registration.suture.h"
#include "surgeon/crossover_model.h"
#include "timing/cycle_watch.h"
#include "vision/knot_vision.suture.h"

namespace robots {

enum class SUTURE_TYPE() ForceFeedback : std::uint8_t {
  None,
  PositionPosition,  ///< force_feedback/position_position.h
};

struct SUTURE_TYPE() OperatorParameters {
  suture::Duration period = std::chrono::milliseconds(1);
  /// The knot shall come here, in the scene.
  SUTURE_FIELD(unit("m")) Eigen::Vector3d target{0, 0, -0.15};
  /// The knot moves this far for a metre of both hands: the scale of the guide, to which operators
  /// adapt themselves.
  SUTURE_FIELD(range(0.01, 10)) double scale = 0.4;
  /// This and the next three are those of McRuer's model (surgeon/crossover_model.h).
  SUTURE_FIELD(unit("rad/s"), range(0.1, 20)) double crossover_frequency = 3;
  /// This time passes from seeing to moving; it is not below zero.
  suture::Duration delay = std::chrono::milliseconds(200);
  /// What is seen has noise. This is its power in each rad/s, divided by the power of the error.
  SUTURE_FIELD(range(0, 1)) double remnant = 0.01;
  /// Equal seeds and pictures give equal noise and tremor.
  std::uint32_t seed = 1;
  /// Each hand's tremor has this root mean square (hand/tremor.h).
  SUTURE_FIELD(unit("m"), range(0, 0.002)) double tremor = 1e-4;
  /// The hands go no faster, whatever the error: our own estimate of careful work.
  SUTURE_FIELD(unit("m/s"), range(0.001, 1)) double speed = 0.2;
  /// The operator does not act on a picture that was exposed longer ago, nor if its camera was
  /// registered so long before it.
  suture::Duration picture_age = std::chrono::seconds(1);
  /// Says what the hands feel of the slaves.
  ForceFeedback force_feedback = ForceFeedback::None;
  /// Each master is drawn this stiffly, and damped this much, to where its slave is known to be.
  SUTURE_FIELD(unit("N/m"), range(0, 5000)) double stiffness = 300;
  SUTURE_FIELD(unit("N.s/m"), range(0, 100)) double damping = 3;
  /// If it is true, each hand also feels what the guide's fixtures forbid it
  /// (force_feedback/fixture_resistance.h): they resist it with so much for each m/s.
  bool feel_fixtures = false;
  SUTURE_FIELD(unit("N.s/m"), range(0, 1000)) double resistance = 60;
  /// If it is true, the passivity controller works; without it, hands may get more energy than they
  /// gave.
  bool passive = true;
  /// A slave that was measured longer ago is not felt, nor is what was forbidden longer ago.
  suture::Duration slave_age = std::chrono::milliseconds(300);
};

/// Takes the place of a KnotSurgeon, and looks: what it sees of the knot in the picture, however
/// late that comes, leads both hands as the crossover model says. They move as it looks at the
/// console (registration/surgeon_view.h), whatever way masters, camera and slaves are turned.
///
/// A picture that is lost, not valid or too old counts as no error: the hands come to rest once
/// that has passed the operator's own delay, and hold. They also hold while the guide does not
/// guide. Each time they begin from where the masters are.
///
/// With force feedback the motors of both masters are simulated here, with the hands that they
/// push, because the simulated arms go where they are sent, and take no force in addition
/// (README.md). A hand feels where its slave is, as far as the link has brought that, against where
/// it leads it. It can also feel what the guide's fixtures forbid it.
class SUTURE_COMPONENT() Operator final : public suture::PeriodicTask {
 public:
  /// Throws suture::SetupError for an age that is not above zero, or is above a minute.
  explicit Operator(const OperatorParameters& parameters);

  void run() override;

  /// The operator's thread. Return the energy in J that each hand has given to the motors that push
  /// it, along the axis that has least; each
  /// feedback has an account of its own, and this is the lower.
  double leftEnergy() const { return left_.energy(); }
  double rightEnergy() const { return right_.energy(); }

 private:
  /// A Side is a hand and the master that it holds.
  struct Side {
    Side(Operator& self, const char* masterName, const char* slaveName,
         const OperatorParameters& parameters, std::uint32_t number);

    bool begin();
    void orient(const Eigen::Matrix3d& newFromMaster, const Eigen::Matrix3d& newFromSlave);
    /// Makes the master go where the hand goes, while the fixtures forbid so much of it, in m/s at
    /// the console. Returns false if the master did not take its goal.
    bool follow(suture::Time now, double seconds, const Eigen::Vector3d& intended,
                const Eigen::Vector3d& forbidden);
    /// Returns the force in N with which the motors push the hand for the next `seconds`, for what
    /// the slave does.
    Eigen::Vector3d forceOfSlave(double seconds);
    double energy() const {
      return std::min(feedback.energy().minCoeff(), resistance.energy().minCoeff());
    }

    const OperatorParameters& parameters;
    suture::Required<Arm> master, slave;  // the slave is needed for force feedback alone
    ArmWatch watch{master};
    Eigen::Isometry3d start = Eigen::Isometry3d::Identity();  // of the master, in its base frame
    // These rotate to directions at the console: from those in the master's base frame, and from
    // those in the slave's base frame that look the same.
    Eigen::Matrix3d fromMaster = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d fromSlave = Eigen::Matrix3d::Identity();
    Hand hand;  // from where it began, m in the console's directions
    PositionPosition feedback;
    FixtureResistance resistance;
    RateFilter<3> slaveRate;
    // The slave was here while the hand was at its origin, to the scale of the master, in m;
    // none while it is not felt.
    std::optional<Eigen::Vector3d> slaveStart;
  };

  /// Returns the way of the knot to its target as it looks at the console, in m; zero if the
  /// operator does not see it.
  Eigen::Vector3d seenError(suture::Time now);
  bool orient();
  ForbiddenMotion forbiddenAtConsole();
  void begin();
  void lead(suture::Time now, double seconds, const Eigen::Vector3d& error);

  const OperatorParameters parameters_;
  Side left_, right_;
  suture::Required<Guidance> guidance_{*this, "Guidance"};
  suture::Required<KnotVision> vision_{*this, "Vision"};
  suture::Required<Registration> registration_{*this, "Registration"};
  CycleWatch cycles_;
  CrossoverModel model_;
  bool guided_ = false;
  bool holds_ = false;  // both masters, since the hands began where those were
  Eigen::Vector3d intended_ = Eigen::Vector3d::Zero();  // of both hands, m as Side::hand
  suture::Time last_;                                   // cycle
};

}  // namespace robots
