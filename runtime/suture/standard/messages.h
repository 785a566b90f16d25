#pragma once
// This is what a component says to people: cisst's and CRTK's status, warning and error.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <cstdint>
#include <string>

namespace suture {

struct SUTURE_TYPE() Message {
  /// The text is UTF-8, for people. A sender cuts a longer text, and ends it in "..." then.
  SUTURE_FIELD(capacity(255)) std::string text;
  /// Says what it is about, by numbers that its sender documents; 0 means nothing in particular.
  std::uint32_t code = 0;
  /// Counts the messages of its sender, of all three kinds together, from 1. A gap says that the
  /// listener has missed some; a number seen before says that the last one was sent again.
  std::uint32_t counter = 0;
  suture::Time stamp;
};

/// Any component may provide this (message_port.h), and any contract may derive from it (then
/// message_sender.h sends); a client that listens to messages can connect to both. Each client
/// keeps up to 16 of a kind that it has not handled; more are dropped and counted. A client that
/// comes late gets the last of each kind.
class SUTURE_INTERFACE() Messages {
 public:
  virtual ~Messages() = default;

  /// Reports that something has been done, and nothing is wrong.
  SUTURE_EVENT(latched(), queue(16)) suture::EventOf<Message> status;
  /// Reports that something was refused, or is not as it should be; the component goes on.
  SUTURE_EVENT(latched(), queue(16)) suture::EventOf<Message> warning;
  /// Reports that something failed, and needs somebody's attention.
  SUTURE_EVENT(latched(), queue(16)) suture::EventOf<Message> error;
};

}  // namespace suture
