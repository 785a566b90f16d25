#include "compiler/emit/text/code.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

namespace suture::compiler::emit {
namespace {

constexpr std::size_t kStep = 2;

bool isMark(char c) { return c == kBreak || c == kBody || c == kBodyEnd; }

/// Returns the text on one line, with a blank at either side of a body.
std::string onOneLine(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (c == kBody || c == kBodyEnd) line += ' ';
    if (!isMark(c)) line += c;
  }
  return line;
}

/// Returns where the body that begins at `open` ends.
std::size_t endOfBody(std::string_view text, std::size_t open) {
  unsigned depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    if (text[i] == kBody) ++depth;
    if (text[i] == kBodyEnd && --depth == 0) return i;
  }
  return text.size();
}

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == at) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// Knows the brackets that are open at the end of a line.
class Brackets {
 public:
  void read(std::string_view text, std::size_t column) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      const bool arrow = text[i] == '>' && i > 0 && text[i - 1] == '-';
      if (std::string_view("(<{[").find(text[i]) != std::string_view::npos) {
        open_.push_back(column + i + 1);
      } else if (!arrow && std::string_view(")>}]").find(text[i]) != std::string_view::npos) {
        if (!open_.empty()) open_.pop_back();
      }
    }
  }

  std::size_t continuation(const std::string& line, std::size_t indent) const {
    const bool justOpened = !open_.empty() && open_.back() == line.size();
    return open_.empty() || justOpened ? indent + 2 * kStep : open_.back();
  }

 private:
  std::vector<std::size_t> open_;  // the column behind each
};

void trimRight(std::string& text) { text.erase(text.find_last_not_of(' ') + 1); }

}  // namespace

Code& Code::function(const std::string& signature, const std::string& statement) {
  const std::string whole = signature + " { " + statement + " }";
  if (depth_ * kStep + onOneLine(whole).size() <= kColumns) return line(whole);
  return open(signature, " {").line(statement).close("}");
}

Code& Code::choice(const std::string& label, const std::string& statement) {
  const std::string whole = label + " " + statement;
  if (depth_ * kStep + onOneLine(whole).size() <= kColumns) return line(whole);
  open(label).line(statement);
  --depth_;
  return *this;
}

Code& Code::write(std::string_view text) {
  const std::size_t own = std::min(text.find_first_not_of(' '), text.size());
  write(text.substr(own), depth_ * kStep + own);
  return *this;
}

void Code::write(std::string_view text, std::size_t indent) {
  const std::string whole = onOneLine(text);
  const std::size_t body = text.find(kBody);
  if (indent + whole.size() <= kColumns) {
    text_ += std::string(indent, ' ') + whole + '\n';
  } else if (body == std::string_view::npos) {
    wrap(text, indent);
  } else {
    const std::size_t end = endOfBody(text, body);
    const std::size_t base = wrap(text.substr(0, body), indent);
    write(text.substr(body + 1, end - body - 1), base + kStep);
    write(text.substr(end + 1), base);
  }
}

/// Returns the indentation of the last line.
std::size_t Code::wrap(std::string_view text, std::size_t indent) {
  std::string line(indent, ' ');
  std::size_t last = indent;
  Brackets brackets;
  for (const std::string& part : split(text, kBreak)) {
    std::string shown = part;
    trimRight(shown);
    if (line.size() > last && line.size() + shown.size() > kColumns) {
      last = brackets.continuation(line, indent);
      trimRight(line);
      text_ += line + '\n';
      line = std::string(last, ' ');
    }
    brackets.read(part, line.size());
    line += part;
  }
  text_ += line + '\n';
  return last;
}

Code& Code::blank() {
  if (!text_.ends_with("\n\n")) text_ += '\n';
  return *this;
}

std::string Code::finished() const {
  return text_.substr(0, text_.find_last_not_of('\n') + 1) + "\n";
}

Code& Code::verbatim(std::string_view text) {
  text_ += text;
  return *this;
}

Code& Code::doc(std::string_view text) {
  std::istringstream lines{std::string(text)};
  for (std::string one; std::getline(lines, one);) {
    if (one.ends_with('\\')) one += " .";  // else the next line would belong to the comment
    text_ += std::string(depth_ * kStep, ' ') + (one.empty() ? "///" : "/// " + one) + '\n';
  }
  return *this;
}

Code& Code::remark(std::string_view text) {
  const std::size_t width = kColumns - depth_ * kStep - std::string_view("/// ").size();
  std::istringstream words{std::string(text)};
  std::string lines, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > width) {
      lines += std::exchange(line, "") + '\n';
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return doc(lines + line);
}

Code& Code::close(std::string_view text) {
  --depth_;
  return write(text);
}

Code& Code::label(std::string_view text) {
  text_ += std::string(depth_ * kStep - 1, ' ').append(text) + '\n';
  return *this;
}

void CommentedLines::add(std::string line, std::string comment) {
  entries_.push_back({std::move(line), std::move(comment)});
}

void CommentedLines::writeTo(Code& code) const {
  for (std::size_t i = 0; i < entries_.size();) {
    std::size_t end = i;
    std::size_t width = 0;
    for (; end < entries_.size() && !entries_[end].comment.empty(); ++end) {
      width = std::max(width, entries_[end].line.size());
    }
    for (; i < end; ++i) {
      const std::string pad(width - entries_[i].line.size() + 2, ' ');
      code.line(entries_[i].line, pad, "// ", entries_[i].comment);
    }
    if (i < entries_.size() && entries_[i].comment.empty()) code.line(entries_[i++].line);
  }
}

}  // namespace suture::compiler::emit
