#include "recorder/recorder.h"

namespace robots {
namespace {

// The ring holds four seconds of one arm at 1 kHz.
constexpr std::size_t kRecords = 4096;

}  // namespace

Recorder::Recorder(const RecorderParameters& parameters)
    : PeriodicTask({.period = parameters.period}), writer_(parameters.file, kRecords) {
  arm_.on().operating_state(
      [this](const OperatingState& state) { enabled_ = state.state == ArmState::Enabled; });
  teleop_.on().followed([this](const FollowAnchors& anchors) { keep(anchors); });
  stop_.on().stop([this](const StopNews& news) { keep(news); });
}

void Recorder::run() {
  const auto measured = arm_.measured_cp();
  const auto setpoint = arm_.setpoint_cp();
  if (!measured || !setpoint || !measured->valid || measured->stamp == last_) return;
  last_ = measured->stamp;
  keep(ArmRow{measured->stamp, measured->pose, setpoint->stamp, setpoint->pose, enabled_});
}

void Recorder::keep(const Record& record) {
  (void)writer_.push(record);  // it counts the records for which it has no room
}

}  // namespace robots
