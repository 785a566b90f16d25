#pragma once
// The calls of a connection that may lose a command or its answer.

#include <suture/component/channel/channel.h>

#include <array>
#include <cstdint>

namespace suture {

/// What the provider's end says of its calls now and then.
struct CallsMark {
  std::uint64_t reached;  ///< no command up to this number will arrive there any more
  std::array<std::uint32_t, Channel::kMaxCalls> atProvider;  ///< not answered yet; 0: none
};

/// One thread. Sees to it that each call is answered to the client at least once: one that is never
/// answered would keep its place for ever. A second answer is dropped by the client's carrier.
class CallsUnderWay {
 public:
  /// The client's end sends `call` as message `sequence`.
  void sent(std::uint32_t call, std::uint64_t sequence);
  /// True if any has not been settled.
  bool any() const;
  /// The client's end has heard `mark`, and no answer that was sent before it will come any more:
  /// calls `lose(call)` for each that has been answered, or will never be executed.
  template <class Lose>
  void settle(const CallsMark& mark, const Lose& lose);

  /// The provider has been given `call`, or has answered it.
  void given(std::uint32_t call) { atProvider_[call % Channel::kMaxCalls] = call; }
  void answered(std::uint32_t call) { atProvider_[call % Channel::kMaxCalls] = 0; }
  CallsMark mark(std::uint64_t reached) const { return {reached, atProvider_}; }

 private:
  struct Sent {
    std::uint32_t call = 0;  // 0: none
    std::uint64_t sequence = 0;
  };

  std::array<Sent, Channel::kMaxCalls> sent_{};
  std::array<std::uint32_t, Channel::kMaxCalls> atProvider_{};
};

template <class Lose>
void CallsUnderWay::settle(const CallsMark& mark, const Lose& lose) {
  for (Sent& one : sent_) {
    const bool settled = one.call != 0 && one.sequence <= mark.reached &&
                         mark.atProvider[one.call % Channel::kMaxCalls] != one.call;
    if (!settled) continue;
    lose(one.call);
    one.call = 0;
  }
}

}  // namespace suture
