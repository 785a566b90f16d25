#pragma once
// These are the words of a capnp file.

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace suture::compiler::lock {

/// Says where a lock cannot be read, and why. It never leaves lock::read().
class SyntaxError : public std::runtime_error {
 public:
  enum class Kind { Damaged, Conflict, Newer };

  SyntaxError(unsigned where, const std::string& what, Kind why = Kind::Damaged)
      : std::runtime_error(what), line(where), kind(why) {}
  unsigned line;
  Kind kind;
};

struct Token {
  /// The text is an identifier, a number, a string with its quotes, "->", or one character; "" is
  /// the end of the file.
  std::string text;
  unsigned line = 0;
};

/// Splits the text into words without its comments; the last one is the end of the file. Throws
/// SyntaxError.
std::vector<Token> tokenize(std::string_view text);

}  // namespace suture::compiler::lock
