#include <suture/base/errors.h>
#include <suture/base/slots/scratch.h>
#include <suture/component/channel/channel.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/guest_task.h>
#include <suture/component/task/task.h>

#include <algorithm>
#include <string>
#include <utility>

namespace suture {
namespace {

/// Makes room before a thread's first cycle with these interfaces, because no cycle allocates.
template <class Provided, class Required>
void makeRoom(const Provided& provided, const Required& required) {
  for (const auto* one : provided) reserveScratch(largestSlot(one->info()));
  for (const auto* one : required) reserveScratch(largestSlot(one->info()));
}

}  // namespace

/// Says for as long as it exists that the thread which owns the task runs its code.
class Task::InCycle {
 public:
  explicit InCycle(Task& task) : inCycle_(task.inCycle_) { set(true); }
  InCycle(const InCycle&) = delete;
  InCycle& operator=(const InCycle&) = delete;
  ~InCycle() { set(false); }

 private:
  void set(bool in) { inCycle_.store(in, std::memory_order_release); }

  std::atomic<bool>& inCycle_;
};

// The owner is known before inCycle_ is set, so a thread that has owned the task before, and stops
// it while another begins a cycle, is not taken for that one.
void Task::refuseToStopInCycle() {
  if (!inCycle_.load(std::memory_order_acquire) || !ownedByThisThread()) return;
  throw SetupError("stopping '" + name() + "'",
                   "it is asked for in its own thread, which would wait for itself",
                   "Stop it in the thread that started it; in its own, request() a suspension");
}

void Task::lend(GuestTask& guest) {
  guest.accept(*this);
  guests_.push_back(&guest);
}

bool Task::isConnected() const {
  return std::any_of(provided().begin(), provided().end(),
                     [](const ProvidedBase* one) { return !one->channels().empty(); }) ||
         std::any_of(required().begin(), required().end(),
                     [](const RequiredBase* one) { return one->pending(); }) ||
         std::any_of(guests_.begin(), guests_.end(),
                     [](const GuestTask* guest) { return guest->isConnected(); });
}

void Task::claimThread() {
  if (!ownedByThisThread()) {
    claimForThisThread();
    makeRoom(provided(), required());
  }
  for (GuestTask* guest : guests_) guest->claimThread();
}

void Task::prepare() {
  if (after(state(), Transition::Configure)) configure();
  for (GuestTask* guest : guests_) guest->prepare();
}

void Task::enter() {
  setEnding(false);
  claimForThisThread();
  const InCycle here(*this);
  makeRoom(provided(), required());
  activity_.run(now());
  if (after(state(), Transition::Start)) makeTransition(Transition::Start);
  makeSafe();
  ringNow();
  for (GuestTask* guest : guests_) guest->enter();
}

void Task::take(Transition transition) {
  requested_.store(transition, std::memory_order_release);
  doorbell().ring();
}

void Task::parkSoon(std::string reason) {
  if (failing_.test_and_set()) return;
  failure_ = std::move(reason);
  failed_.store(true, std::memory_order_release);
  doorbell().ring();
}

void Task::parkIfAsked() {
  if (!failed_.load(std::memory_order_acquire)) return;
  park(failure_);
  failed_.store(false, std::memory_order_relaxed);
  failing_.clear(std::memory_order_release);  // once restarted, it may fail again
}

// A request from before a fault is carried out after the restart.
bool Task::requestDue() const {
  return requested_.load(std::memory_order_relaxed).has_value() && !awaitsRestart_;
}

void Task::makeRequestedTransition() {
  if (!requestDue()) return;
  const auto requested = requested_.exchange(std::nullopt, std::memory_order_acquire);
  if (!after(state(), *requested)) return;  // it was parked after this, and not restarted
  activity_.run(now());
  makeTransition(*requested);
  if (state() != ComponentState::Running) rest();
  makeSafe();
}

void Task::cycle() {
  const InCycle here(*this);
  parkIfAsked();
  if (goesOn()) parkOnThrow([this] { work(); });
  if (state() != ComponentState::Running) rest();
  makeSafe();  // a task that is restarted can still do what is requested
  makeRequestedTransition();
  ringNow();
  for (GuestTask* guest : guests_) guest->cycle();
}

void Task::restartAfterFaults(const RestartBudget& budget) {
  if (budget.most > RestartBudget::kMost) {
    throw SetupError("restarting '" + name() + "' after faults",
                     std::to_string(budget.most) + " restarts",
                     "Allow at most " + std::to_string(RestartBudget::kMost));
  }
  if (budget.most > 0 && budget.per <= Duration{0}) {
    throw SetupError("restarting '" + name() + "' after faults",
                     std::to_string(budget.most) + " restarts in any time of " +
                         std::to_string(budget.per.count()) + " ns",
                     "Give a time greater than zero");
  }
  restarts_ = budget;
}

// A restart may fail and so be another fault; the budget bounds that too, and so does a stop, which
// a budget of a short time would outlast.
void Task::makeSafe() {
  while (state() == ComponentState::Faulted) {
    if (safeAfter_ != faults()) {
      safeAfter_ = faults();
      activity_.run(now());
      awaitsRestart_ = tryOnFault() && meantToRun_ && !ending() && budgetLasts();
      staysFaulted_.store(!awaitsRestart_, std::memory_order_release);
    }
    if (!awaitsRestart_ || ending() || lacksProvider()) return;
    awaitsRestart_ = false;
    restart();
  }
}

// Notices each loss, so that none of those before the restart faults it afterwards.
bool Task::lacksProvider() {
  bool lacks = false;
  for (RequiredBase* interface : required()) {
    interface->updateConnection();
    lacks = interface->lossFaults() || lacks;
  }
  return lacks;
}

bool Task::tryOnFault() {
  try {
    runHook([this] { onFault(); });
    return true;
  } catch (...) {  // the reason for the fault says more than what onFault() threw
    return false;
  }
}

// The restart that was `most` restarts ago must be longer ago than `per`.
bool Task::budgetLasts() {
  if (restarts_.most == 0) return false;
  Time& oldest = restartedAt_[restartTurn_ % restarts_.most];
  const Time present = now();
  if (oldest != Time{} && present - oldest < restarts_.per) return false;
  oldest = present;
  ++restartTurn_;
  return true;
}

bool Task::goesOn() const { return state() == ComponentState::Running && !ending(); }

void Task::work() {
  const Time begin = now();
  activity_.run(begin);
  handleEvents();
  if (!goesOn()) return;
  for (ProvidedBase* interface : provided()) interface->drain();
  if (!goesOn()) return;
  run();
  for (ProvidedBase* interface : provided()) interface->publishRow();
  ringNow();
  const Time end = now();
  statistics_.computeTime.record(end - begin);
  statistics_.windows.cycle(begin, end, statistics_.skipped.load(std::memory_order_relaxed));
  statistics_.cycles.store(statistics_.cycles.load(std::memory_order_relaxed) + 1,
                           std::memory_order_relaxed);
}

// Does the part of a cycle that runs no user code, but for interfaces served in every state. What
// one of these throws keeps no other from its turn.
void Task::rest() {
  statistics_.windows.interrupt();
  for (RequiredBase* interface : required()) interface->adopt();
  for (ProvidedBase* interface : provided()) {
    parkOnThrow([interface] {
      interface->drain();
      if (interface->inService()) interface->publishRow();
    });
  }
}

// Refuses the commands that still wait, so that each has an answer, also those that came while
// onStop() ran. By then the clients have been told, so no more are sent.
void Task::leave() {
  const InCycle here(*this);
  setEnding(true);
  for (GuestTask* guest : guests_) guest->leave();
  refuseWaiting();
  endLife();
  refuseWaiting();
  ringNow();
  releaseThread();
}

void Task::refuseWaiting() {
  for (ProvidedBase* interface : provided()) interface->drain();
}

bool Task::ownWorkPending() const {
  const bool running = state() == ComponentState::Running;
  return requestDue() || failed_.load(std::memory_order_relaxed) ||
         std::any_of(provided().begin(), provided().end(),
                     [](const ProvidedBase* one) { return one->pending(); }) ||
         std::any_of(required().begin(), required().end(), [running](RequiredBase* one) {
           return running ? one->pending() || one->unseen() : one->rewired();
         });
}

bool Task::workPending() const {
  return ownWorkPending() ||
         std::any_of(guests_.begin(), guests_.end(),
                     [](const GuestTask* guest) { return guest->workPending(); });
}

bool Task::allRest() const {
  return state() != ComponentState::Running &&
         std::all_of(guests_.begin(), guests_.end(),
                     [](const GuestTask* guest) { return guest->allRest(); });
}

}  // namespace suture
