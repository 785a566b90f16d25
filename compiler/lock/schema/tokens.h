#pragma once
// The words of a capnp file.

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace suture::compiler::lock {

/// A place in a lock that cannot be read. Never leaves lock::read().
class SyntaxError : public std::runtime_error {
 public:
  enum class Kind { Damaged, Conflict, Newer };

  SyntaxError(unsigned where, const std::string& what, Kind why = Kind::Damaged)
      : std::runtime_error(what), line(where), kind(why) {}
  unsigned line;
  Kind kind;
};

struct Token {
  /// An identifier, a number, a string with its quotes, "->", or one character; "" = end of file.
  std::string text;
  unsigned line = 0;
};

/// Comments are dropped. The last token is the end of file. Throws SyntaxError.
std::vector<Token> tokenize(std::string_view text);

}  // namespace suture::compiler::lock
