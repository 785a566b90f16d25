#pragma once
// Writes C++ text line by line, indented and wrapped.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace suture::compiler::emit {

/// Marks where a line that is too long may be broken; reads as nothing when it is not. The rest is
/// set as clang-format sets it: under what follows the open bracket, or four deeper right behind a
/// bracket.
inline constexpr char kBreak = '\v';

/// These stand around the body of a lambda, inside its braces: a line that is too long becomes
/// three there.
inline constexpr char kBody = '\x0e';
inline constexpr char kBodyEnd = '\x0f';

class Code {
 public:
  static constexpr std::size_t kColumns = 100;

  /// Writes one line of the concatenated pieces at the present indentation. It breaks at kBreak
  /// characters when it is longer than kColumns; a blank before a break goes with it.
  template <class... Pieces>
  Code& line(const Pieces&... pieces) {
    std::string text;
    (text.append(pieces), ...);
    return write(text);
  }

  /// Writes an empty line, unless the last one is empty.
  Code& blank();
  /// Copies the text as it is, indentation and all.
  Code& verbatim(std::string_view text);
  /// Writes a `///` comment of as many lines as the text has; nothing when it is empty.
  Code& doc(std::string_view text);
  /// Writes a `///` comment of one paragraph, which it breaks into lines.
  Code& remark(std::string_view text);

  /// Writes `line`, then everything one step deeper until close().
  template <class... Pieces>
  Code& open(const Pieces&... pieces) {
    line(pieces...);
    ++depth_;
    return *this;
  }
  Code& close(std::string_view text);
  /// Writes a function of one statement, on one line if that is enough.
  Code& function(const std::string& signature, const std::string& statement);
  /// Writes a label of a switch and its one statement, on one line if that is enough.
  Code& choice(const std::string& label, const std::string& statement);
  /// Writes a label such as "public:" or "case x:", half a step out in a class.
  Code& label(std::string_view text);

  const std::string& text() const { return text_; }
  /// Returns the text without blank lines at its end.
  std::string finished() const;

 private:
  Code& write(std::string_view text);
  void write(std::string_view text, std::size_t indent);
  std::size_t wrap(std::string_view text, std::size_t indent);

  std::string text_;
  std::size_t depth_ = 0;
};

/// Writes lines that end in a comment, the comments in one column, as clang-format sets them.
class CommentedLines {
 public:
  void add(std::string line, std::string comment);
  void writeTo(Code& code) const;

 private:
  struct Entry {
    std::string line, comment;
  };
  std::vector<Entry> entries_;
};

}  // namespace suture::compiler::emit
