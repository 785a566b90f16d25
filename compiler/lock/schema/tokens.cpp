#include "compiler/lock/schema/tokens.h"

#include <algorithm>
#include <cctype>

namespace suture::compiler::lock {
namespace {

bool isWordCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

class Tokenizer {
 public:
  explicit Tokenizer(std::string_view text) : text_(text) {}

  std::vector<Token> run() {
    std::vector<Token> tokens;
    while (skipBlanks()) tokens.push_back({next(), line_});
    tokens.push_back({"", line_});
    return tokens;
  }

 private:
  bool skipBlanks() {
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '#') at_ = std::min(text_.find('\n', at_), text_.size());
      if (at_ == text_.size()) return false;
      if (text_[at_] == '\n') ++line_;
      if (std::isspace(static_cast<unsigned char>(text_[at_])) == 0) return true;
    }
    return false;
  }

  std::string next() {
    const std::string_view rest = text_.substr(at_);
    for (const std::string_view marker : {"<<<<<<<", "=======", ">>>>>>>"}) {
      if (!rest.starts_with(marker)) continue;
      throw SyntaxError(line_, "a merge conflict is not resolved", SyntaxError::Kind::Conflict);
    }
    if (rest.front() == '"') return string();
    std::size_t length = rest.starts_with("->") ? 2 : 1;
    const bool isNumber = rest.front() == '-' && length == 1;
    if (isWordCharacter(rest.front()) || isNumber) {
      while (length < rest.size() && continues(rest, length)) ++length;
    }
    at_ += length;
    return std::string(rest.substr(0, length));
  }

  /// Tells if the word goes on here. "1e-05" is one word, because a sign belongs to the exponent
  /// before it.
  static bool continues(std::string_view rest, std::size_t i) {
    const bool number = std::isdigit(static_cast<unsigned char>(rest[0])) != 0 || rest[0] == '-';
    const bool hexadecimal = rest.starts_with("0x");
    const bool exponentSign = (rest[i] == '-' || rest[i] == '+') && number && !hexadecimal &&
                              (rest[i - 1] == 'e' || rest[i - 1] == 'E');
    return isWordCharacter(rest[i]) || exponentSign;
  }

  std::string string() {
    std::size_t end = at_ + 1;
    for (; end < text_.size() && text_[end] != '"' && text_[end] != '\n'; ++end) {
      if (text_[end] == '\\') ++end;
    }
    if (end >= text_.size() || text_[end] != '"') throw SyntaxError(line_, "a string has no end");
    std::string result(text_.substr(at_, end + 1 - at_));
    at_ = end + 1;
    return result;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  unsigned line_ = 1;
};

}  // namespace

std::vector<Token> tokenize(std::string_view text) { return Tokenizer(text).run(); }

}  // namespace suture::compiler::lock
