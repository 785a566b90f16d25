#pragma once
// The reference page and the comments of a generated client say alike how a call reaches the
// component, and how an event reaches a subscriber.

#include <cstdint>
#include <string>

#include "compiler/model/model.h"

namespace suture::compiler::emit {

/// Tells if a command is answered from the newest row, without asking the component.
bool isRead(const model::Command& command);
/// Tells if a command waits in the component's queue.
bool isQueued(const model::Command& command);
/// Tells if the component answers a command.
bool isAnswered(const model::Command& command);

/// Returns "Qualified read": the kind of a command, as docs/annotations.md names it.
std::string kindWords(model::CommandKind kind);

/// Returns "Write: up to 16 wait.": what a caller has to know of a command's way to the component
/// and back.
std::string callWords(const model::Command& command);

/// Returns "At a subscriber up to 16 wait. Who subscribes later gets the last one."
std::string deliveryWords(const model::Event& event);

/// Returns "20 ms" or "1.5 s".
std::string durationWords(std::int64_t nanoseconds);

/// Returns "from -0.5 to 2"; "" without a range.
std::string rangeWords(const model::Limits& limits);

/// Returns " speed is in m/s, from 0 to 2."; "" if nothing limits it.
std::string limitWords(const std::string& name, const model::Limits& limits);

}  // namespace suture::compiler::emit
