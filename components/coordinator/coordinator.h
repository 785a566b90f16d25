#pragma once
// This is the component on whose permit all drives of a system depend.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/provided.h>
#include <suture/component/task/periodic_task.h>
#include <suture/standard/message_port.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "coordinator/emergency_stop.suture.h"
#include "timing/cycle_watch.h"

namespace robots {

struct SUTURE_TYPE() CoordinatorParameters {
  /// The permit is renewed once in this period, and a command to stop may wait as long.
  suture::Duration period = std::chrono::milliseconds(1);
  /// Names the clients without which nobody could press the stop, such as "desk:Panel/Stop". One
  /// whose connection ends presses it, and it is not released before all are connected.
  SUTURE_FIELD(capacity(8, 63)) std::vector<std::string> buttons;
};

/// Permits drives to have power until somebody presses the stop. It starts pressed, because one
/// that is started again does not know if it was pressed: an operator releases it. For the same
/// reason it is pressed when it goes on after a suspension, or after a pause in which the commands
/// of its clients may have been lost: a long one, or one in which a client ended its connection or
/// was lost by its short silence. The end of a button's connection presses it at any time.
class SUTURE_COMPONENT() Coordinator final : public suture::PeriodicTask, public EmergencyStop {
 public:
  explicit Coordinator(const CoordinatorParameters& parameters);

  void press() override { stopDrives(false); }
  void release(std::uint64_t press) override;
  Permit permit() const override { return permit_; }

  void run() override;
  void onStart() override { begin(true); }
  void onRestart() override { begin(true); }
  void onResume() override { begin(false); }
  void onClient(const suture::ProvidedBase& interface, const suture::ConnectedClient& client,
                suture::ClientNews news) override;

 private:
  static constexpr suture::Duration kNobodyIsGone = suture::Duration::max();

  void begin(bool isStart);
  void stopDrives(bool isStart);
  void noticePause();
  /// Returns true if a client has gone since the last cycle, and a pause may have lost its press;
  /// `pause` is the time since that cycle.
  bool losesPress(suture::Duration pause);
  bool forgetNewcomer(const suture::ConnectedClient& client);
  bool canBePressed() const;

  std::map<std::string, unsigned, std::less<>> buttons_;  // how many connections each has
  CycleWatch cycles_;
  StopNews news_{true, {}, true, 0};  // the last
  bool buttonIsGone_ = false;         // since the last cycle
  bool pauseIsNoticed_ = false;       // the one before this cycle
  suture::Duration pause_{0};         // the longest of those that still count
  suture::Time pauseEnded_{};         // the last of them
  // A longer pause may have lost a press of a client that has gone since the last cycle.
  suture::Duration harmlessPause_ = kNobodyIsGone;
  // They have come since the last pause; one for which there is no place counts as earlier.
  std::array<const suture::ConnectedClient*, 16> newcomers_{};
  Permit permit_;
  suture::Provided<EmergencyStop> stop_{*this, "Stop", *this};
  suture::MessagePort messages_{*this};
};

}  // namespace robots
