#pragma once
// What a component says to people: cisst's and CRTK's status, warning and error.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <cstdint>
#include <string>

namespace suture {

struct SUTURE_TYPE() Message {
  /// UTF-8, for people. Those who send cut what is longer, and end it in "..." then.
  SUTURE_FIELD(capacity(255)) std::string text;
  /// What it is about, by numbers that its sender documents; 0: nothing in particular.
  std::uint32_t code = 0;
  /// Counts the messages of its sender, of all three kinds together, from 1: a gap says that the
  /// listener has missed some, a number seen before that the last one has been told again.
  std::uint32_t counter = 0;
  suture::Time stamp;
};

/// Any component may provide it (message_port.h), and any contract may derive from it (then
/// message_sender.h sends); whoever listens to messages can connect to both. Each listener keeps
/// up to 16 of a kind that it has not handled; more are dropped and counted. Who comes late gets
/// the last of each kind.
class SUTURE_INTERFACE() Messages {
 public:
  virtual ~Messages() = default;

  /// All is well; something has been done.
  SUTURE_EVENT(latched(), queue(16)) suture::EventOf<Message> status;
  /// Something was refused, or is not as it should be; the component goes on.
  SUTURE_EVENT(latched(), queue(16)) suture::EventOf<Message> warning;
  /// Something failed, and somebody should see to it.
  SUTURE_EVENT(latched(), queue(16)) suture::EventOf<Message> error;
};

}  // namespace suture
