#include <suture/base/errors.h>
#include <suture/component/contract/unbounded.h>
#include <suture/lane/delay/delay_thread.h>

#include <algorithm>
#include <iterator>
#include <string>

namespace suture {

DelayThread::DelayThread(const rt::Scheduling& scheduling) : ThreadTask(scheduling) { start(); }

DelayThread::~DelayThread() {
  stop();
  takeOver();
  for (const auto& one : carried_) one->end();
}

void DelayThread::requireBounded(const InterfaceInfo& contract) {
  const std::string why = whyUnbounded(contract);
  if (why.empty()) return;
  throw SetupError(std::string("a delay on a connection of ") + contract.name, why,
                   "Give it a capacity()");
}

std::shared_ptr<Channel> DelayThread::interpose(const RequiredBase& required,
                                                std::shared_ptr<Channel> far,
                                                const ConnectionDelay& delay) {
  auto state = makeStateTable(required.info(), rt::StateTable::Readers::Here);
  state->resize(static_cast<unsigned>(far->state->capacity()));
  const Channel::Ends ends{.client = required.owner().sharedDoorbell(),
                           .provider = sharedDoorbell(),
                           .components = ConnectionEnd::Client,
                           .peer = far->ends.peer,
                           .silence = far->ends.silence};
  auto near = std::make_shared<Channel>(required.info(), far->terms,
                                        far->lane + (delay.faults.any() ? "+fault" : "+delay"),
                                        ends, std::move(state), far->subscribed());
  auto connection = std::make_unique<DelayedConnection>(near, std::move(far), delay);
  {
    const std::lock_guard lock(mutex_);
    added_.push_back(std::move(connection));
  }
  doorbell().ring();
  return near;
}

void DelayThread::takeOver() {
  const std::lock_guard lock(mutex_);
  std::move(added_.begin(), added_.end(), std::back_inserter(carried_));
  added_.clear();
}

bool DelayThread::awaitCycle() {
  Time due = Time::max();
  for (const auto& one : carried_) due = std::min(due, one->due());
  if (!ending() && now() < due) doorbell().waitUntil(due);
  return !ending();
}

void DelayThread::run() {
  takeOver();
  for (const auto& one : carried_) one->pump(now());
  std::erase_if(carried_, [](const auto& one) {
    const bool over = one->over();
    if (over) one->end();
    return over;
  });
}

}  // namespace suture
