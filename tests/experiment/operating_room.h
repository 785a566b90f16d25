#pragma once
// The whole system of a trial: the console, the operating table, and the link between them.

#include <suture/component/required.h>
#include <suture/manager/manager.h>

#include <Eigen/Geometry>
#include <chrono>
#include <cstdint>

#include "arm/arm.suture.h"
#include "arm/arm_watch.h"
#include "experiment/camera.h"
#include "experiment/trial.h"
#include "guidance/knot_guide.h"
#include "integration/teleoperation/driven_arm.h"
#include "registration/registration_table.h"
#include "strand/strand.h"
#include "strand/strand_simulation.h"

namespace experiment {

/// Gives an arm power and homes it, as the guide does with those that it drives.
class Readier final : public suture::PeriodicTask {
 public:
  Readier() : PeriodicTask({.period = std::chrono::milliseconds(1)}) {}

 private:
  void run() override { watch_.prepare(); }

  suture::Required<robots::Arm> arm_{*this, "Arm"};
  robots::ArmWatch watch_{arm_};
};

/// Two masters and who holds them are the console; two slaves, the guide with its fixtures, the
/// strand and the camera are the table. The guide is at the table, so what crosses the link are the
/// poses of the masters, and on the way back the sightings and what the guide does.
///
/// Used by the thread that made the stepped clock. What it reads between two advances is the truth
/// of that instant.
class OperatingRoom {
 public:
  OperatingRoom(const Trial& trial, const CameraModel& camera);
  ~OperatingRoom() { manager_.stop(); }
  OperatingRoom(const OperatingRoom&) = delete;
  OperatingRoom& operator=(const OperatingRoom&) = delete;

  /// Who moves the masters, as "Surgeon", and looks; must live as long as this. It requires "Left",
  /// "Right" and "Vision"; an operator also what connectOperator() connects.
  void seat(suture::Task& surgeon);
  void connectOperator();
  void start() { manager_.start(); }
  void stop() { manager_.stop(); }

  bool guiding() const { return guide_.guidance_state() == robots::GuidanceState::Guiding; }
  /// Where the knot is, in the scene, m.
  Eigen::Vector3d knot() const { return strand_.strand().nodes.col(robots::Strand::kKnot); }

  /// A slave and the master that leads it, where they are now, each in its own base frame.
  struct Pair {
    Eigen::Isometry3d master, slave, setpoint;
  };
  Pair left() const { return pairOf(leftMaster_, leftSlave_); }
  Pair right() const { return pairOf(*rightLead_, rightSlave_); }

  static constexpr double kScale = 0.4;  ///< slave metres a master metre

 private:
  void connectTable();
  void connectMasters();
  static Pair pairOf(const robots::test::DrivenMtm& master, const robots::test::DrivenPsm& slave);
  suture::ConnectionDelay overLink(suture::Duration period);

  const Trial trial_;
  const suture::Duration picturePeriod_;
  std::uint64_t crossings_ = 0;  // connections over the link
  robots::test::DrivenMtm leftMaster_{robots::MtmSide::Left}, rightMaster_{robots::MtmSide::Right};
  robots::test::DrivenPsm leftSlave_, rightSlave_;
  const robots::test::DrivenMtm* rightLead_;
  robots::KnotGuide guide_;
  robots::RegistrationTable registration_;
  robots::StrandSimulation strand_{robots::StrandParameters{}};
  Camera camera_;
  Readier readier_;
  suture::Manager manager_{"room"};
};

}  // namespace experiment
