#pragma once
// These are the calls of a connection that may lose a command or its answer.

#include <suture/component/channel/channel.h>

#include <array>
#include <cstdint>

namespace suture {

/// This is what the provider's end says of its calls from time to time.
struct CallsMark {
  std::uint64_t reached;  ///< no command up to this number will arrive there any more
  std::array<std::uint32_t, Channel::kMaxCalls> atProvider;  ///< not answered yet; 0: none
};

/// One thread. Makes sure that the client gets at least one answer to each call, because a call
/// without an answer would keep its place for ever. The client's carrier drops a second answer.
class CallsUnderWay {
 public:
  /// Notes that the client's end sends `call` as message `sequence`.
  void sent(std::uint32_t call, std::uint64_t sequence);
  /// Returns true if any call has not been settled.
  bool any() const;
  /// The client's end has got `mark`, and no answer that was sent before it will come any more.
  /// Calls `lose(call)` for each call that has been answered, or will never be executed.
  template <class Lose>
  void settle(const CallsMark& mark, const Lose& lose);

  /// Note that the provider has got `call`, or has answered it.
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
