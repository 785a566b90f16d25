#pragma once
// This makes texts fit to be shown, whoever wrote them, and to be copied into a shell.

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

/// Returns the command that tells more of a message: `suture why "..."`, with the first line of it
/// and without its place in a file.
std::string whyCommand(std::string_view message);

}  // namespace suture
