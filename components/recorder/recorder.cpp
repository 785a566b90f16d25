#include "recorder/recorder.h"

#include <suture/component/read_together.h>

#include <utility>

namespace robots {
namespace {

// The ring holds four seconds of one arm at 1.5 kHz.
constexpr std::size_t kRecords = 6144;

}  // namespace

Recorder::Recorder(const RecorderParameters& parameters)
    : PeriodicTask({.period = parameters.period}), writer_(parameters.file, kRecords) {
  arm_.on().operating_state(
      [this](const OperatingState& state) { enabled_ = state.state == ArmState::Enabled; });
  teleop_.on().followed([this](const FollowAnchors& anchors) { keep(anchors); });
  teleop_.on().teleop_state([this](const TeleopState& state) { hear(state); });
  stop_.on().stop([this](const StopNews& news) { keep(news); });
}

void Recorder::run() {
  const auto row = suture::readTogether(arm_.measured_cp, arm_.setpoint_cp);
  if (!row) return;
  const auto& [measured, setpoint] = *row;
  if (!measured.valid || measured.stamp == last_) return;
  last_ = measured.stamp;
  keep(ArmRow{measured.stamp, measured.pose, setpoint.stamp, setpoint.pose, enabled_});
}

void Recorder::hear(TeleopState state) {
  const bool clutched = state == TeleopState::Clutched;
  if (std::exchange(clutched_, clutched) != clutched) keep(ClutchNews{clutched, suture::now()});
}

void Recorder::keep(const Record& record) {
  (void)writer_.push(record);  // it counts the records for which it has no room
}

}  // namespace robots
