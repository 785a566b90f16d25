#pragma once
// This is the task that records an arm and, if connected, the teleoperation that drives it and the
// emergency stop.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <chrono>
#include <cstdint>
#include <string>

#include "arm/arm.suture.h"
#include "coordinator/emergency_stop.suture.h"
#include "recorder/recording.h"
#include "recorder/recording_writer.h"
#include "teleop/teleoperation.suture.h"

namespace robots {

struct SUTURE_TYPE() RecorderParameters {
  /// Must be at least as fast as the arm, or cycles are missed.
  suture::Duration period = std::chrono::milliseconds(1);
  /// The file gets one JSON line for each record. It is replaced at the start.
  SUTURE_FIELD(capacity(255)) std::string file = "recording.jsonl";
};

/// Reads measured and commanded pose in each cycle and records what is new. The file is complete
/// once this is destroyed.
class SUTURE_COMPONENT() Recorder final : public suture::PeriodicTask {
 public:
  /// Throws suture::SetupError if the file cannot be written.
  explicit Recorder(const RecorderParameters& parameters);

  void onConfigure() override { writer_.open(); }
  void onStart() override { writer_.begin(); }
  void run() override;

  /// Any thread. Returns how many records are not in the file, because it was too slow or its disk
  /// is full.
  std::uint64_t dropped() const { return writer_.lost(); }

 private:
  void keep(const Record& record);
  void hear(TeleopState state);

  RecordingWriter<Record> writer_;
  suture::Required<Arm> arm_{*this, "Arm"};
  SUTURE_REQUIRED(optional()) suture::Required<Teleoperation> teleop_{*this, "Teleoperation"};
  SUTURE_REQUIRED(optional()) suture::Required<EmergencyStop> stop_{*this, "Stop"};
  suture::Time last_;
  bool enabled_ = false;
  bool clutched_ = false;
};

}  // namespace robots
