#pragma once
// With these words the two ends of a channel tell each other what the queues do not carry.

#include <suture/component/contract/interface_info.h>
#include <suture/rt/shared_flag.h>

#include <array>
#include <atomic>
#include <cstdint>

namespace suture {

/// They lie first in the memory of a channel, which another process may write at any time.
struct ChannelWords {
  /// Limits how many calls with an answer may be unfinished at a time.
  static constexpr unsigned kMaxCalls = 16;

  /// Either end claims a call: the client in order to cancel it, the provider to execute it.
  /// Returns true for the end that claims it first.
  bool claim(std::uint32_t call) {
    return claims[call % kMaxCalls].exchange(call, std::memory_order_acq_rel) != call;
  }

  std::atomic<EventSet> subscribed{0}, joining{0};
  std::array<std::atomic<std::uint32_t>, kMaxCalls> claims{};  // 0 is no call's number
  rt::SharedFlag wantsRows, untaken, cut;
};

}  // namespace suture
