#pragma once
// This writes a message without allocating.

#include <suture/base/plain.h>
#include <suture/standard/messages.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace suture {

/// One thread at a time. Keeps one message, and with it the memory of its text.
class MessageDraft {
 public:
  /// Allocates what the longest text needs.
  MessageDraft() { message_.text.reserve(kCapacity); }

  /// Returns a message that is stamped now and valid until the next call. A text of more than 255
  /// bytes is cut between two characters and ends in "...", because a part of a message is better
  /// than none.
  const Message& write(std::string_view text, std::uint32_t code, std::uint32_t counter) {
    assignCut(message_.text, text, kCapacity);
    message_.code = code;
    message_.counter = counter;
    message_.stamp = now();
    return message_;
  }

 private:
  static constexpr std::size_t kCapacity = 255;  // as Message declares

  Message message_;
};

}  // namespace suture
