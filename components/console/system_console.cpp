#include "console/system_console.h"

#include <suture/base/errors.h>

#include <algorithm>
#include <utility>

#include "parameters/valid_time.h"

namespace robots {
namespace {

constexpr suture::Duration kAskAgain = std::chrono::milliseconds(500);
// Arms on their way home stop in a pause of the machine, which this console then sees as well.
constexpr suture::Duration kPause = std::chrono::milliseconds(50);
constexpr std::size_t kLongestText = 255;
constexpr std::string_view kInFault = "is in FAULT: remove the cause, then enable or disable it";

template <class Part>
Part* named(const std::string& name, const std::vector<Part*>& parts) {
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&](const Part* one) { return one->name() == name; });
  return found == parts.end() ? nullptr : *found;
}

template <class Part, class Is>
Part* firstThatIsNot(const std::vector<Part*>& parts, const Is& is) {
  const auto found = std::find_if_not(parts.begin(), parts.end(), is);
  return found == parts.end() ? nullptr : *found;
}

[[noreturn]] void refuse(const std::string& name, const char* found, const char* remedy) {
  throw suture::SetupError("a system with the part '" + name + "'", found, remedy);
}

}  // namespace

SystemConsole::SystemConsole(const SystemConsoleParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      parameters_(parameters),
      stopHearing_(stop_),
      byItself_(parameters.bring_up_by_itself) {
  requireTime("patience", parameters.patience);
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
  look();
  const std::string_view why = missing();
  if (!why.empty()) return messages_.error(why);
  for (ArmPart* one : arms_) one->begin();
  enter(ConsoleState::Enabling);
}

// Even a console that is down leaves all parts, because it may have been restarted since they were
// brought up.
void SystemConsole::bring_down() {
  byItself_ = false;
  enter(ConsoleState::Leaving);
}

void SystemConsole::look() {
  if (!stopHearing_.look()) released_ = false;
  for (ArmPart* one : arms_) one->look();
  for (MoverPart* one : movers_) one->look();
}

std::string_view SystemConsole::missing() {
  text_.clear();
  unnamed_ = 0;
  if (!isReleased()) nameMissing("the emergency stop", "is pressed, or says nothing");
  for (const ArmPart* one : arms_) {
    if (one->isFaulted()) {
      nameMissing(one->name(), kInFault);
    } else if (!one->isThere()) {
      nameMissing(one->name(), "has no power permitted, or says nothing");
    }
  }
  for (const MoverPart* one : movers_) {
    if (!one->isThere()) nameMissing(one->name(), "says nothing");
  }
  if (unnamed_ > 0) text_.append("; and ").append(std::to_string(unnamed_)).append(" more");
  return text_;
}

void SystemConsole::nameMissing(std::string_view name, std::string_view what) {
  constexpr std::size_t kMore = 16;  // bytes of "; and 4 more"
  const std::string_view begin = text_.empty() ? "bring_up: " : "; ";
  const std::size_t size = begin.size() + name.size() + 1 + what.size();
  if (text_.size() + size + kMore > kLongestText) {
    ++unnamed_;
  } else {
    text_.append(begin).append(name).append(" ").append(what);
  }
}

void SystemConsole::run() {
  look();
  if (cycles_.missed(kPause)) {
    for (ArmPart* one : arms_) one->goOn();  // so that they are asked to home again
  }
  tellLostPower();
  tellUse();
  takeStep();
  for (ArmPart* one : arms_) one->endCycle();
}

void SystemConsole::takeStep() {
  switch (state_) {
    case ConsoleState::Down:
      if (byItself_ && missing().empty()) beginByItself();
      return;
    case ConsoleState::Enabling: return enableNext();
    case ConsoleState::Homing: return awaitHome();
    case ConsoleState::Up:
    case ConsoleState::Incomplete: return watch();
    case ConsoleState::Leaving: return leaveNext();
  }
}

// A system that has been up already may have been brought down by somebody, before this console was
// restarted.
void SystemConsole::beginByItself() {
  const auto used =
      std::find_if(arms_.begin(), arms_.end(), [](const ArmPart* one) { return one->hasHomed(); });
  if (used == arms_.end()) return bring_up();
  byItself_ = false;
  const auto isUp = [](const auto* one) { return !one->isDown(); };
  if (std::any_of(arms_.begin(), arms_.end(), isUp) ||
      std::any_of(movers_.begin(), movers_.end(), isUp)) {
    return enter(ConsoleState::Incomplete);
  }
  text_.assign((*used)->name()).append(" has homed before this console began; ask for bring_up");
  messages_.warning(text_);
}

void SystemConsole::tellLostPower() {
  for (ArmPart* one : arms_) {
    if (!one->hasLostPower()) continue;
    text_.assign(one->name()).append(" has no power, may not have it, or is cut off");
    messages_.warning(text_, static_cast<std::uint32_t>(ArmWarning::PowerLost));
  }
}

// A console that has seen its system used keeps that in mind, because arms may be restarted too.
void SystemConsole::tellUse() {
  if (use_ == SystemUse::Used) return;
  const auto isHeard = [](const ArmPart* one) { return one->isHeard(); };
  const auto wasUsed = [](const ArmPart* one) { return one->wasUsed(); };
  SystemUse use = SystemUse::Unknown;
  if (std::all_of(arms_.begin(), arms_.end(), isHeard)) use = SystemUse::Unused;
  if (std::any_of(arms_.begin(), arms_.end(), wasUsed)) use = SystemUse::Used;
  if (std::exchange(use_, use) != use) console_.emit().system_use(use);
}

// Enables one arm after the other: the next gets power when the one before it holds.
void SystemConsole::enableNext() {
  if (isBroken()) return;
  if (done_ == arms_.size()) return enter(ConsoleState::Homing);
  ArmPart& next = *arms_[done_];
  if (next.isEnabled()) {
    ++done_;
    deadline_ = suture::now() + parameters_.patience;
    return;
  }
  if (mayAsk(&next)) next.enable();
  checkDeadline(next.name(), "enabled");
}

// All arms home at the same time, each by itself. Once all are home they may move again, because
// what is enabled next moves them.
void SystemConsole::awaitHome() {
  done_ = arms_.size();
  if (isBroken()) return;
  ArmPart* const last = firstThatIsNot(arms_, [](const ArmPart* one) { return one->isReady(); });
  allHome_ = allHome_ || last == nullptr;
  if (allHome_) return enableMovers();
  if (mayAsk(&arms_)) {
    for (ArmPart* one : arms_) one->home();
  }
  checkDeadline(last->name(), "homed");
}

void SystemConsole::enableMovers() {
  MoverPart* const next =
      firstThatIsNot(movers_, [](const MoverPart* one) { return one->isReady(); });
  if (next == nullptr) return enter(ConsoleState::Up);
  if (next != askedPart_) deadline_ = suture::now() + parameters_.patience;
  if (mayAsk(next)) next->enable();
  checkDeadline(next->name(), "enabled");
}

bool SystemConsole::isBroken() {
  if (!isReleased()) {
    undoBringUp("the emergency stop", {"was pressed meanwhile, or says nothing any more"});
    return true;
  }
  const auto inFault = [](const ArmPart* one) { return one->isFaulted(); };
  const auto faulted = std::find_if(arms_.begin(), arms_.end(), inFault);
  if (faulted != arms_.end()) {
    undoBringUp((*faulted)->name(), {kInFault});
    return true;
  }
  for (std::size_t i = 0; i < done_; ++i) {
    if (arms_[i]->isEnabled()) continue;
    undoBringUp(arms_[i]->name(), {"is not enabled any more"});
    return true;
  }
  return false;
}

void SystemConsole::watch() {
  const auto isHomed = [](const ArmPart* one) { return one->isHomed(); };
  const auto isReady = [](const MoverPart* one) { return one->isReady(); };
  const bool complete = isReleased() && std::all_of(arms_.begin(), arms_.end(), isHomed) &&
                        std::all_of(movers_.begin(), movers_.end(), isReady);
  if (complete == (state_ == ConsoleState::Up)) return;
  enter(complete ? ConsoleState::Up : ConsoleState::Incomplete);
}

void SystemConsole::leaveNext() {
  if (done_ < movers_.size()) return leave(*movers_[movers_.size() - 1 - done_]);
  const std::size_t arms = done_ - movers_.size();
  if (arms < arms_.size()) return leave(*arms_[arms_.size() - 1 - arms]);
  enter(ConsoleState::Down);
}

// A part that is not there any more cannot be asked, and counts as down. One that does not obey
// must not keep the others from being left.
template <class Part>
void SystemConsole::leave(Part& part) {
  const bool gaveUp = suture::now() >= deadline_;
  if (part.isDown() || gaveUp) {
    if (!part.isDown()) {
      messages_.error(text_.assign(part.name()).append(" is not disabled, though asked to be"));
    }
    ++done_;
    deadline_ = suture::now() + parameters_.patience;
  } else if (mayAsk(&part)) {
    part.disable();
  }
}

void SystemConsole::enter(ConsoleState state) {
  state_ = state;
  done_ = 0;
  allHome_ = false;
  askedPart_ = nullptr;
  deadline_ = suture::now() + parameters_.patience;
  console_.emit().console_state(state);
}

void SystemConsole::checkDeadline(const std::string& part, std::string_view what) {
  if (suture::now() >= deadline_)
    undoBringUp(part, {"is not ", what, " after the console's patience"});
}

void SystemConsole::undoBringUp(std::string_view part,
                                std::initializer_list<std::string_view> why) {
  text_.assign(part).append(" ");
  for (const std::string_view words : why) text_.append(words);
  messages_.error(text_.append("; all is taken back"));
  enter(ConsoleState::Leaving);
}

bool SystemConsole::mayAsk(const void* part) {
  const suture::Time now = suture::now();
  if (part == askedPart_ && now - asked_ < kAskAgain) return false;
  askedPart_ = part;
  asked_ = now;
  return true;
}

}  // namespace robots
