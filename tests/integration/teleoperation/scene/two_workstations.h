#pragma once
// A master drives a slave, in one process or over a lane, and both are recorded.

#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <chrono>
#include <string>

#include "integration/teleoperation/scene/driven_arm.h"
#include "recorder/recorder.h"
#include "recorder/recording.h"
#include "support/temporary_directory.h"
#include "surgeon/surgeon.h"
#include "teleop/teleop.h"

namespace robots::test {

/// The thread that made the stepped clock uses this. The console has the master, its surgeon and
/// the teleoperation, the robot has the slave; each has a recorder. On Lane::Auto both are one
/// process. What the master tells takes `delay` longer.
class TwoWorkstations {
 public:
  TwoWorkstations(const suture::Lane& lane, suture::Duration delay)
      : lane_(lane), delay_(delay), teleop_({.scale = kScale, .max_age = kFresh + delay}) {
    equipConsole();
    slave_.addTo(robot(), "PSM");
    robot().add("SlaveRecorder", slaveRecorder_);
    robot().connect("SlaveRecorder/Arm", "PSM/Arm");
    console_.start();
    if (!isOneProcess()) elsewhere_.start();
    console_.connect("Teleop/Slave", isOneProcess() ? "PSM/Arm" : "robot:PSM/Arm", {.lane = lane_});
    robot().connect("SlaveRecorder/Teleoperation",
                    isOneProcess() ? "Teleop/Teleoperation" : "console:Teleop/Teleoperation",
                    {.lane = lane_});
  }
  ~TwoWorkstations() { stop(); }
  TwoWorkstations(const TwoWorkstations&) = delete;
  TwoWorkstations& operator=(const TwoWorkstations&) = delete;

  void stop() {
    elsewhere_.stop();
    console_.stop();
  }
  /// Reads what was recorded, once it is stopped.
  Recording master() const { return readRecording(masterFile()); }
  Recording slave() const { return readRecording(slaveFile()); }
  const Recorder& slaveRecorder() const { return slaveRecorder_; }

  static constexpr double kScale = 0.4;  ///< slave metres a master metre

 private:
  static constexpr suture::Duration kFresh = std::chrono::milliseconds(20);

  bool isOneProcess() const { return lane_ == suture::Lane::Auto; }
  suture::Manager& robot() { return isOneProcess() ? console_ : elsewhere_; }
  std::string masterFile() const { return directory_.file("master.jsonl"); }
  std::string slaveFile() const { return directory_.file("slave.jsonl"); }

  void equipConsole() {
    master_.addTo(console_, "MTM");
    console_.add("Surgeon", surgeon_);
    console_.add("Teleop", teleop_);
    console_.add("MasterRecorder", masterRecorder_);
    console_.connect("Surgeon/Master", "MTM/Arm");
    console_.connect("Surgeon/Teleoperation", "Teleop/Teleoperation");
    console_.connect("Teleop/Master", "MTM/Arm", {.delay = {.answers = delay_}});
    console_.connect("MasterRecorder/Arm", "MTM/Arm");
  }

  const suture::Lane lane_;
  const suture::Duration delay_;
  const suture::TemporaryDirectory directory_;
  suture::loop::ControlThread control_;
  suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  DrivenMtm master_;
  DrivenPsm slave_;
  Surgeon surgeon_{SurgeonParameters{}};
  Teleop teleop_;
  Recorder masterRecorder_{{.file = masterFile()}}, slaveRecorder_{{.file = slaveFile()}};
  suture::Manager console_{"console", names_.address()}, elsewhere_{"robot", names_.address()};
};

}  // namespace robots::test
