#include <suture/lane/delay/calls_under_way.h>

#include <algorithm>

namespace suture {

void CallsUnderWay::sent(std::uint32_t call, std::uint64_t sequence) {
  sent_[call % Channel::kMaxCalls] = {call, sequence};
}

bool CallsUnderWay::any() const {
  return std::any_of(sent_.begin(), sent_.end(), [](const Sent& one) { return one.call != 0; });
}

}  // namespace suture
