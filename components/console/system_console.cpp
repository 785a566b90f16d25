#include "console/system_console.h"

#include <suture/base/errors.h>

#include <algorithm>

namespace robots {
namespace {

constexpr suture::Duration kAskAgain = std::chrono::milliseconds(500);
constexpr std::size_t kLongestText = 255;

template <class Part>
Part* named(const std::string& name, const std::vector<Part*>& parts) {
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&](const Part* one) { return one->name() == name; });
  return found == parts.end() ? nullptr : *found;
}

template <class Part>
bool areThere(const std::vector<Part*>& parts) {
  return std::all_of(parts.begin(), parts.end(), [](const Part* one) { return one->isThere(); });
}

template <class Part, class Is>
Part* firstThatIsNot(const std::vector<Part*>& parts, const Is& is) {
  const auto found = std::find_if_not(parts.begin(), parts.end(), is);
  return found == parts.end() ? nullptr : *found;
}

template <class Part, class Is>
Part* lastThatIsNot(const std::vector<Part*>& parts, const Is& is) {
  const auto found = std::find_if_not(parts.rbegin(), parts.rend(), is);
  return found == parts.rend() ? nullptr : *found;
}

[[noreturn]] void refuse(const std::string& name, const char* found, const char* remedy) {
  throw suture::SetupError("a system with the part '" + name + "'", found, remedy);
}

}  // namespace

SystemConsole::SystemConsole(const SystemConsoleParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      parameters_(parameters),
      byItself_(parameters.bring_up_by_itself) {
  text_.reserve(kLongestText);
  stop_.on().stop([this](const StopNews& news) { released_ = !news.pressed; });
  for (const std::string& name : parameters.system) choose(name);
}

void SystemConsole::choose(const std::string& name) {
  const std::vector<ArmPart*> arms{&mtmlPart_, &mtmrPart_, &psm1Part_, &psm2Part_};
  const std::vector<MoverPart*> movers{&teleopLPart_, &teleopRPart_, &guidePart_};
  if (named(name, arms_) != nullptr || named(name, movers_) != nullptr) {
    refuse(name, "it is named already", "Name each part once");
  }
  ArmPart* const arm = named(name, arms);
  if (arm != nullptr && !movers_.empty()) {
    refuse(name, "something that moves arms is named before it", "Name all arms first");
  }
  if (arm != nullptr) return arms_.push_back(arm);
  MoverPart* const mover = named(name, movers);
  if (mover == nullptr) {
    refuse(name, "this console knows MTML, MTMR, PSM1, PSM2, TeleopL, TeleopR and Guide",
           "Use one of those names");
  }
  movers_.push_back(mover);
}

void SystemConsole::bring_up() {
  byItself_ = false;
  if (state_ != ConsoleState::Down) {
    return messages_.error("bring_up: it is not down; bring it down first");
  }
  const std::string_view why = missing();
  if (!why.empty()) return messages_.error(why);
  enter(ConsoleState::Enabling);
}

void SystemConsole::bring_down() {
  byItself_ = false;
  if (state_ != ConsoleState::Down) enter(ConsoleState::Leaving);
}

std::string_view SystemConsole::missing() {
  text_.clear();
  if (!released_) nameMissing("the emergency stop", "is pressed, or says nothing");
  for (const ArmPart* one : arms_) {
    if (!one->isThere()) nameMissing(one->name(), "is not there, or has no power permitted");
  }
  for (const MoverPart* one : movers_) {
    if (!one->isThere()) nameMissing(one->name(), "is not there");
  }
  return text_;
}

void SystemConsole::nameMissing(std::string_view name, std::string_view what) {
  const std::string_view begin = text_.empty() ? "bring_up: " : "; ";
  if (text_.size() + begin.size() + name.size() + 1 + what.size() > kLongestText) return;
  text_.append(begin).append(name).append(" ").append(what);
}

void SystemConsole::run() {
  switch (state_) {
    case ConsoleState::Down:
      if (byItself_ && missing().empty()) bring_up();
      return;
    case ConsoleState::Enabling: return enableNext();
    case ConsoleState::Homing: return awaitHome();
    case ConsoleState::Up:
    case ConsoleState::Incomplete: return watch();
    case ConsoleState::Leaving: return leaveNext();
  }
}

// One after the other: the next gets power when the one before it holds.
void SystemConsole::enableNext() {
  ArmPart* const next = firstThatIsNot(arms_, [](const ArmPart* one) { return one->isEnabled(); });
  if (next == nullptr) return enter(ConsoleState::Homing);
  if (mayAsk()) next->enable();
  judge(next->name(), "enabled");
}

// All at once: each moves by itself.
void SystemConsole::awaitHome() {
  ArmPart* const last = firstThatIsNot(arms_, [](const ArmPart* one) { return one->isReady(); });
  if (last == nullptr) {
    for (MoverPart* one : movers_) one->enable();
    return enter(ConsoleState::Up);
  }
  if (mayAsk()) {
    for (ArmPart* one : arms_) one->home();
  }
  judge(last->name(), "homed");
}

void SystemConsole::watch() {
  const bool complete =
      released_ && areThere(movers_) &&
      std::all_of(arms_.begin(), arms_.end(), [](const ArmPart* one) { return one->isReady(); });
  if (complete == (state_ == ConsoleState::Up)) return;
  enter(complete ? ConsoleState::Up : ConsoleState::Incomplete);
}

// A part that is not there any more cannot be asked, and is as good as down.
void SystemConsole::leaveNext() {
  const bool mayAskNow = mayAsk();
  const auto isDown = [](const auto* one) { return one->isDown(); };
  if (MoverPart* const mover = lastThatIsNot(movers_, isDown)) {
    if (mayAskNow) mover->disable();
  } else if (ArmPart* const arm = lastThatIsNot(arms_, isDown)) {
    if (mayAskNow) arm->disable();
  } else {
    enter(ConsoleState::Down);
  }
}

void SystemConsole::enter(ConsoleState state) {
  state_ = state;
  asked_ = {};
  deadline_ = suture::now() + parameters_.patience;
  console_.emit().console_state(state);
}

void SystemConsole::judge(const std::string& part, std::string_view what) {
  if (suture::now() < deadline_) return;
  text_ = part;
  text_.append(" is not ").append(what).append(" after the console's patience; all is taken back");
  messages_.error(text_);
  enter(ConsoleState::Leaving);
}

bool SystemConsole::mayAsk() {
  const suture::Time now = suture::now();
  if (now - asked_ < kAskAgain) return false;
  asked_ = now;
  return true;
}

}  // namespace robots
