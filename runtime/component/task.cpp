#include <suture/base/errors.h>
#include <suture/component/channel.h>
#include <suture/component/guest_task.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task.h>

#include <algorithm>
#include <exception>

namespace suture {

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
  claimForThisThread();
  for (GuestTask* guest : guests_) guest->claimThread();
}

void Task::enter() {
  claimForThisThread();
  setState(ComponentState::Running);
  for (GuestTask* guest : guests_) guest->enter();
}

void Task::cycle() {
  if (state() != ComponentState::Faulted) {
    try {
      cycleAlone();
    } catch (const std::exception& error) {
      park(error.what());
    } catch (...) {
      park("an exception that is not a std::exception");
    }
    ringNow();
  }
  for (GuestTask* guest : guests_) guest->cycle();
}

void Task::cycleAlone() {
  const Time begin = now();
  handleEvents();
  for (ProvidedBase* interface : provided()) interface->drain();
  run();
  for (ProvidedBase* interface : provided()) interface->publishRow();
  ringNow();
  const Time end = now();
  statistics_.computeTime.record(end - begin);
  statistics_.windows.cycle(begin, end, statistics_.skipped.load(std::memory_order_relaxed));
  statistics_.cycles.store(statistics_.cycles.load(std::memory_order_relaxed) + 1,
                           std::memory_order_relaxed);
}

void Task::leave() {
  for (GuestTask* guest : guests_) guest->leave();
  for (ProvidedBase* interface : provided()) interface->announce(ChannelStatus::Lost);
  if (state() == ComponentState::Running) setState(ComponentState::Stopped);
  releaseThread();
}

bool Task::workPending() const {
  const auto pending = [](const auto* one) { return one->pending(); };
  const bool own = state() != ComponentState::Faulted &&
                   (std::any_of(provided().begin(), provided().end(), pending) ||
                    std::any_of(required().begin(), required().end(), pending));
  return own || std::any_of(guests_.begin(), guests_.end(),
                            [](const GuestTask* guest) { return guest->workPending(); });
}

bool Task::allParked() const {
  return state() == ComponentState::Faulted &&
         std::all_of(guests_.begin(), guests_.end(),
                     [](const GuestTask* guest) { return guest->allParked(); });
}

}  // namespace suture
