#pragma once
// This is the task that records how a knot is placed.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <chrono>
#include <cstdint>
#include <string>

#include "guidance/guidance.suture.h"
#include "recorder/knot_recording.h"
#include "recorder/recording_writer.h"
#include "registration/registration.suture.h"
#include "strand/strand_view.suture.h"
#include "vision/knot_vision.suture.h"

namespace robots {

struct SUTURE_TYPE() KnotRecorderParameters {
  suture::Duration period = std::chrono::milliseconds(20);
  /// The file gets one JSON line for each row. It is replaced at the start.
  SUTURE_FIELD(capacity(255)) std::string file = "knot.jsonl";
};

/// Records one row in each cycle, once there is a strand. The file is complete once this is
/// destroyed.
class SUTURE_COMPONENT() KnotRecorder final : public suture::PeriodicTask {
 public:
  /// Throws suture::SetupError if the file cannot be written.
  explicit KnotRecorder(const KnotRecorderParameters& parameters);

  void onConfigure() override { writer_.open(); }
  void onStart() override { writer_.begin(); }
  void run() override;

  /// Any thread. Returns how many records are not in the file, because it was too slow or its disk
  /// is full.
  std::uint64_t dropped() const { return writer_.lost(); }

 private:
  RecordingWriter<KnotRow> writer_;
  suture::Required<StrandView> strand_{*this, "Strand"};
  suture::Required<KnotVision> vision_{*this, "Vision"};
  suture::Required<Guidance> guidance_{*this, "Guidance"};
  suture::Required<Registration> registration_{*this, "Registration"};
  KnotRow row_;
  bool guiding_ = false;  // by the last event; a lost guide sends none
};

}  // namespace robots
