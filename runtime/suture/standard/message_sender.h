#pragma once
// This sends the status, warning and error of a contract that derives from Messages.

#include <suture/standard/message_draft.h>
#include <suture/standard/messages.suture.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <string_view>

namespace suture {

/// A MessageSender is a member of the component, beside what provides the contract:
///   suture::Provided<Arm> arm_{*this, "Arm", *this};
///   suture::MessageSender<Arm> messages_{arm_};
///   messages_.warning("the goal is out of reach");
/// The component's thread sends; for a device, any. Sending neither allocates nor waits. Texts of
/// more than 255 bytes are cut (MessageDraft). `code` is Message::code.
template <class Contract>
class MessageSender {
 public:
  explicit MessageSender(Provided<Contract>& provided) : provided_(provided) {}

  /// Emits the event status: something has been done, and nothing is wrong.
  void status(std::string_view text, std::uint32_t code = 0) {
    send([&](const Message& message) { (void)provided_.emit().status(message); }, text, code);
  }
  /// Emits the event warning: something was refused, or is not as it should be; the component goes
  /// on.
  void warning(std::string_view text, std::uint32_t code = 0) {
    send([&](const Message& message) { (void)provided_.emit().warning(message); }, text, code);
  }
  /// Emits the event error: something failed, and needs somebody's attention.
  void error(std::string_view text, std::uint32_t code = 0) {
    send([&](const Message& message) { (void)provided_.emit().error(message); }, text, code);
  }

 private:
  struct Desk {
    std::atomic_flag taken = ATOMIC_FLAG_INIT;
    MessageDraft draft;
  };

  // Only a device is ever at a second desk. If all are taken the message is lost, and a gap in the
  // counters tells it: a thread that waited here might wait for one that it keeps from running.
  template <class Emit>
  void send(const Emit& emit, std::string_view text, std::uint32_t code) {
    const std::uint32_t counter = counter_.fetch_add(1, std::memory_order_relaxed) + 1;
    for (Desk& desk : desks_) {
      if (desk.taken.test_and_set(std::memory_order_acquire)) continue;
      emit(desk.draft.write(text, code, counter));
      desk.taken.clear(std::memory_order_release);
      return;
    }
  }

  Provided<Contract>& provided_;
  std::atomic<std::uint32_t> counter_{0};
  std::array<Desk, 4> desks_;
};

}  // namespace suture
