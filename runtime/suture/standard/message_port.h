#pragma once
// This offers a component's messages as a provided interface.

#include <suture/component/component.h>
#include <suture/standard/message_sender.h>

#include <string_view>

namespace suture {

/// A MessagePort is a member of a component:
///   suture::MessagePort messages_{*this};         others connect to "PSM/Messages"
///   messages_.error("the encoder does not answer", kNoEncoder);
class MessagePort final : private Messages {
 public:
  explicit MessagePort(Component& owner, std::string_view name = "Messages")
      : provided_(owner, name, *this), sender_(provided_) {}

  /// The component's thread; for a device, any. Neither allocates nor waits, as in MessageSender.
  void status(std::string_view text, std::uint32_t code = 0) { sender_.status(text, code); }
  void warning(std::string_view text, std::uint32_t code = 0) { sender_.warning(text, code); }
  void error(std::string_view text, std::uint32_t code = 0) { sender_.error(text, code); }

 private:
  Provided<Messages> provided_;
  MessageSender<Messages> sender_;
};

}  // namespace suture
