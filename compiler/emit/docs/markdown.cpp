#include "compiler/emit/docs/markdown.h"

#include <algorithm>
#include <cctype>

namespace suture::compiler::emit {
namespace {

/// Returns the text on one line and without what would end a cell.
std::string cell(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '|') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

}  // namespace

std::string MarkdownTable::text() const {
  if (rows_.empty()) return "";
  std::string result = line(titles_);
  for (std::size_t i = 0; i < titles_.size(); ++i) result += isUsed(i) ? "| --- " : "";
  result += "|\n";
  for (const std::vector<std::string>& row : rows_) result += line(row);
  return result + "\n";
}

std::string MarkdownTable::line(const std::vector<std::string>& cells) const {
  std::string result;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (isUsed(i)) result += cells[i].empty() ? "| " : "| " + cell(cells[i]) + " ";
  }
  return result + "|\n";
}

bool MarkdownTable::isUsed(std::size_t column) const {
  return std::any_of(rows_.begin(), rows_.end(),
                     [column](const auto& row) { return !row[column].empty(); });
}

std::string inCode(std::string_view text) { return "`" + std::string(text) + "`"; }

std::string prose(std::string_view text) {
  std::string result;
  bool code = false;
  for (const char c : text) {
    if (c == '`') code = !code;
    if (c == '<' && !code) {
      result += "&lt;";
    } else {
      result += c;
    }
  }
  return result;
}

std::string firstSentence(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool ends = i + 1 == text.size() || text[i + 1] == ' ' || text[i + 1] == '\n';
    const bool paragraph = text.substr(i, 2) == "\n\n";
    if (paragraph) break;
    result += text[i] == '\n' ? ' ' : text[i];
    if (text[i] == '.' && ends) break;
  }
  return prose(result);
}

std::string anchorOf(std::string_view heading) {
  std::string result = "#";
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ') result += '-';
    if (c == '_' || c == '-' || std::isalnum(byte) != 0 || byte >= 0x80) {
      result += static_cast<char>(std::tolower(byte));
    }
  }
  return result;
}

std::string link(std::string_view text, std::string_view target) {
  return "[" + std::string(text) + "](" + std::string(target) + ")";
}

}  // namespace suture::compiler::emit
