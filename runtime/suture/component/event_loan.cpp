#include <suture/component/channel/channel.h>
#include <suture/component/event_loan.h>
#include <suture/component/provided.h>

#include <utility>

namespace suture {

EventLoan::EventLoan(ProvidedBase& provided, std::uint16_t event)
    : provided_(provided), event_(event), subscriber_(provided.onlySubscriber(event)) {
  if (subscriber_ != nullptr) memory_ = subscriber_->events.lend(event);
}

EventLoan::~EventLoan() {
  if (memory_ != nullptr) subscriber_->events.giveBack(event_, memory_);
}

Errc EventLoan::emit(bool fits) {
  if (const Errc error = provided_.judge(event_, memory_, fits); error != Errc{}) return error;
  provided_.deliverLent(*subscriber_, event_, std::exchange(memory_, nullptr));
  return Errc{};
}

}  // namespace suture
