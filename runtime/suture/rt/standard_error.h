#pragma once
// Threads that must not wait say on standard error what a person should know.

#include <string_view>

namespace suture::rt {

/// Any thread. Prints `line` and a line end on standard error, of which it takes at most 4 KiB.
/// Returns false if that has no room, because nobody reads it: a terminal that was stopped, or a
/// pipe whose reader sleeps. Then the line is lost. It waits only if another thread takes the last
/// room at that moment.
bool printUnlessFull(std::string_view line);

}  // namespace suture::rt
