#pragma once
// This makes texts fit to be shown, whoever wrote them, and to be copied into a shell; and it leads
// from an error to its page.

#include <cstddef>
#include <string>
#include <string_view>

namespace suture {

/// Returns `text` without control codes, with which the text of a peer could steer a terminal.
std::string plain(const std::string& text);

/// Sets `out` to `text`, of which it takes at most `capacity` bytes: a longer one is cut between
/// two characters (UTF-8) and ends in "...". Allocates nothing if `out` has that capacity.
void assignCut(std::string& out, std::string_view text, std::size_t capacity);

/// Returns `text` in double quotes, in which a shell takes it for one word and changes nothing.
std::string quotedForShell(std::string_view text);

/// Returns `message`, for example the what() of a SetupError, and in a line of its own the command
/// that tells more of its first line: `suture why "..."` tells more. Any thread; it allocates.
std::string explained(std::string_view message);

}  // namespace suture
