#include <suture/lane/delay/calls_under_way.h>

#include <algorithm>

namespace suture {

void CallsUnderWay::sent(std::uint32_t call, std::uint64_t sequence) {
  sent_[call % Channel::kMaxCalls] = {call, sequence};
}

bool CallsUnderWay::end(std::uint32_t call) {
  Sent& one = sent_[call % Channel::kMaxCalls];
  if (one.call != call) return false;
  one.call = 0;
  return true;
}

bool CallsUnderWay::any() const {
  return std::any_of(sent_.begin(), sent_.end(), [](const Sent& one) { return one.call != 0; });
}

}  // namespace suture
