#include <suture/component/channel/channel.h>
#include <suture/component/provided/event_emission.h>
#include <suture/component/provided/event_loan.h>

#include <utility>

namespace suture {

EventLoan::EventLoan(EventEmission& emission, std::uint16_t event)
    : emission_(emission), event_(event), subscriber_(emission.onlySubscriber(event)) {
  if (subscriber_ != nullptr) memory_ = subscriber_->events.lend(event);
}

EventLoan::~EventLoan() {
  if (memory_ != nullptr) subscriber_->events.giveBack(event_, memory_);
}

Errc EventLoan::emit(bool fits) {
  if (const Errc error = emission_.judge(event_, memory_, fits); error != Errc{}) return error;
  emission_.deliverLent(*subscriber_, event_, std::exchange(memory_, nullptr));
  return Errc{};
}

}  // namespace suture
