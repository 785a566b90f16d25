#pragma once
// This is the whole system of a trial in one process: the console, the operating table, and the
// link between them.

#include <suture/manager/manager.h>

#include "experiment/room/camera.h"
#include "experiment/room/console.h"
#include "experiment/room/operating_table.h"
#include "experiment/room/truth.h"
#include "experiment/trial.h"
#include "strand/strand.h"

namespace experiment {

/// The thread that made the stepped clock uses this. What it reads between two advances is the
/// truth of that instant.
class OperatingRoom {
 public:
  OperatingRoom(const Trial& trial, const CameraModel& camera);
  ~OperatingRoom() { manager_.stop(); }
  OperatingRoom(const OperatingRoom&) = delete;
  OperatingRoom& operator=(const OperatingRoom&) = delete;

  /// Adds the task that moves the masters (Console::seat); it must live as long as this.
  void seat(suture::Task& surgeon) { Console::seat(manager_, surgeon, overLink_, picturePeriod_); }
  void connectOperator() { Console::connectOperator(manager_, overLink_, picturePeriod_); }
  void start() { manager_.start(); }
  void stop() { manager_.stop(); }

  bool guiding() const { return table_.guide.guidance_state() == robots::GuidanceState::Guiding; }
  /// Returns where the knot is, in the scene, m.
  Eigen::Vector3d knot() const { return table_.strand.strand().nodes.col(robots::Strand::kKnot); }
  Truth truth() const;

 private:
  const Trial trial_;
  const suture::Duration picturePeriod_;
  Console console_;
  OperatingTable table_;
  suture::Manager manager_{"room"};
  const Crossing overLink_;
};

}  // namespace experiment
