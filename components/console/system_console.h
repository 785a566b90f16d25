#pragma once
// This is the component that brings a telesurgical system up and down.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>
#include <suture/standard/message_sender.h>

#include <chrono>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "console/console.suture.h"
#include "console/parts.h"
#include "coordinator/emergency_stop.suture.h"
#include "timing/cycle_watch.h"

namespace robots {

struct SUTURE_TYPE() SystemConsoleParameters {
  suture::Duration period = std::chrono::milliseconds(10);
  /// The system has these parts, and brings them up in this order: names of required interfaces of
  /// this console. All arms come before what moves them.
  SUTURE_FIELD(capacity(8, 15)) std::vector<std::string> system;
  /// Each of these may take this long: to enable a part, to home all arms, to disable a part.
  suture::Duration patience = std::chrono::seconds(10);
  /// If it is true, the console brings the system up once, without being asked, when everything is
  /// there. It does not if an arm has homed before: then the console was restarted, and somebody
  /// may have brought the system down.
  bool bring_up_by_itself = false;
};

/// Requires four arms, two teleoperations and a guide, which are there if they are named in
/// `system`.
class SUTURE_COMPONENT() SystemConsole final : public suture::PeriodicTask, public Console {
 public:
  /// Throws suture::SetupError for a part that this console does not know, that is named twice, for
  /// an arm behind what moves it, or for a patience that is not from 1 ms to a day.
  explicit SystemConsole(const SystemConsoleParameters& parameters);

  void bring_up() override;
  void bring_down() override;
  ConsoleState console_state() const override { return state_; }

  void run() override;

 private:
  void choose(const std::string& name);
  void look();
  /// Returns true if the stop says that it is released.
  bool isReleased() const { return stopHearing_.counts() && released_; }
  /// Returns for people what keeps the system from being brought up; "" if nothing does. It is
  /// valid until the next call.
  std::string_view missing();
  void nameMissing(std::string_view name, std::string_view what);
  void tellLostPower();
  void tellUse();
  void takeStep();
  void beginByItself();
  void enableNext();
  void awaitHome();
  void enableMovers();
  void watch();
  void leaveNext();
  template <class Part>
  void leave(Part& part);
  void enter(ConsoleState state);
  /// Undoes a bring-up if `part` has had enough time to become `what`.
  void checkDeadline(const std::string& part, std::string_view what);
  /// Undoes a bring-up at once, and returns true, if the stop was pressed, an arm is in FAULT, or
  /// an arm that had power lost it.
  bool isBroken();
  void undoBringUp(std::string_view part, std::initializer_list<std::string_view> why);
  /// Returns true when `part` is asked for the first time, and once in a while, because a command
  /// may be lost.
  bool mayAsk(const void* part);

  const SystemConsoleParameters parameters_;
  suture::Required<EmergencyStop> stop_{*this, "Stop"};
  SUTURE_REQUIRED(optional()) suture::Required<Arm> mtml_{*this, "MTML"};
  SUTURE_REQUIRED(optional()) suture::Required<Arm> mtmr_{*this, "MTMR"};
  SUTURE_REQUIRED(optional()) suture::Required<Arm> psm1_{*this, "PSM1"};
  SUTURE_REQUIRED(optional()) suture::Required<Arm> psm2_{*this, "PSM2"};
  SUTURE_REQUIRED(optional()) suture::Required<Teleoperation> teleopL_{*this, "TeleopL"};
  SUTURE_REQUIRED(optional()) suture::Required<Teleoperation> teleopR_{*this, "TeleopR"};
  SUTURE_REQUIRED(optional()) suture::Required<Guidance> guide_{*this, "Guide"};
  ArmPart mtmlPart_{mtml_}, mtmrPart_{mtmr_}, psm1Part_{psm1_}, psm2Part_{psm2_};
  MoverPart teleopLPart_{teleopL_}, teleopRPart_{teleopR_}, guidePart_{guide_};

  CycleWatch cycles_;
  std::vector<ArmPart*> arms_;      // of the system, in order
  std::vector<MoverPart*> movers_;  // of the system, in order
  Hearing stopHearing_;
  bool released_ = false;  // the stop, as it was reported
  bool byItself_;
  ConsoleState state_ = ConsoleState::Down;
  SystemUse use_ = SystemUse::Unknown;
  std::size_t done_ = 0;             // parts that are enabled, or have been left
  bool allHome_ = false;             // in this bring-up
  suture::Time deadline_;            // for what is asked now
  const void* askedPart_ = nullptr;  // which part was asked
  suture::Time asked_;               // when that was asked last
  std::string text_;                 // keeps its memory
  std::size_t unnamed_ = 0;          // reasons for which the text has no room
  suture::Provided<Console> console_{*this, "Console", *this};
  suture::MessageSender<Console> messages_{console_};
};

}  // namespace robots
