#pragma once
// This counts what Cap'n Proto keeps for a peer that has asked and does not say that it is done.

#include <capnp/rpc.capnp.h>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace suture::framing {

/// Belongs to the control thread. Cap'n Proto keeps each answer until the peer finishes its
/// question, and the number of a question is free until then, so numbers bound the answers.
class UnfinishedAnswers {
 public:
  struct Limits {
    std::uint32_t questions;  ///< at a time
    std::size_t bytes;        ///< the sum over all answers
  };

  /// Notes a message of the peer. Returns which limit it breaks; "" if none.
  std::string_view arrived(capnp::rpc::Message::Reader message, const Limits& limits);
  /// Notes a message to the peer, which takes so many bytes.
  void sent(capnp::rpc::Message::Reader message, std::size_t bytes);

 private:
  struct Answer {
    std::size_t bytes = 0;
    bool isFinished = false;  ///< before it was sent
  };

  void begin(std::uint32_t question);
  void finish(std::uint32_t question);

  std::vector<Answer> answers_;  // by number of the question
  std::size_t bytes_ = 0;        // the sum over unfinished answers
};

}  // namespace suture::framing
