#include "cli/text/error_pages.h"
#include <suture/base/plain.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace suture::cli {
namespace {

std::string lettersOf(std::string_view words) {
  std::string letters;
  for (const unsigned char one : words) {
    if (std::isalnum(one) != 0) letters += static_cast<char>(std::tolower(one));
  }
  return letters;
}

/// Returns "not produced yet" of a page that begins "# not produced yet: `Errc::NotYet`".
std::string_view textOf(std::string_view page) {
  page.remove_prefix(std::min(page.find(' ') + 1, page.size()));
  return page.substr(0, page.find(": `"));
}

/// Returns the cells of a row of a table: "| found | why | what to do |".
std::vector<std::string_view> cellsOf(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 2; begin < line.size();) {
    const std::size_t end = std::min(line.find(" |", begin), line.size());
    cells.push_back(line.substr(begin, end - begin));
    begin = end + 3;
  }
  return cells;
}

/// Tells if `words` have the parts of a pattern such as "it is still ...", in their order.
bool hasParts(std::string_view words, std::string_view pattern) {
  constexpr std::string_view kAny = "...";
  while (!pattern.empty()) {
    const std::size_t end = std::min(pattern.find(kAny), pattern.size());
    const std::size_t at = words.find(pattern.substr(0, end));
    if (at == std::string_view::npos) return false;
    words.remove_prefix(at + end);
    pattern.remove_prefix(std::min(end + kAny.size(), pattern.size()));
  }
  return true;
}

/// Returns the first pattern of a cell "`it is still ...` or `it is ...`" that `words` have, or "".
std::string_view patternIn(std::string_view cell, std::string_view words) {
  constexpr std::string_view kNext = "` or `";
  cell = cell.substr(1, cell.size() - 2);  // without the outer quotes
  while (!cell.empty()) {
    const std::size_t end = std::min(cell.find(kNext), cell.size());
    if (hasParts(words, cell.substr(0, end))) return cell.substr(0, end);
    cell.remove_prefix(std::min(end + kNext.size(), cell.size()));
  }
  return "";
}

/// Returns true for the pages that have tables of messages.
bool hasTables(std::string_view page) { return page.starts_with("set-up") || page == "running"; }

/// This is a row of such a page that is about a message.
struct Row {
  std::string_view page, pattern, cause, remedy;
};

std::vector<Row> rowsOf(std::string_view words) {
  std::vector<Row> rows;
  for (const auto& [name, page] : errorPages()) {
    if (!hasTables(name)) continue;
    for (std::size_t at = page.find("\n| `"); at != std::string_view::npos;
         at = page.find("\n| `", at + 1)) {
      const std::size_t end = std::min(page.find('\n', at + 1), page.size());
      const auto cells = cellsOf(page.substr(at + 1, end - at - 1));
      if (cells.size() != 3) continue;
      const std::string_view pattern = patternIn(cells[0], words);
      if (!pattern.empty()) rows.push_back({name, pattern, cells[1], cells[2]});
    }
  }
  return rows;
}

std::string rowsAsText(const std::string& words) {
  std::string text;
  for (const Row& row : rowsOf(words)) {
    text += "why it happens: " + std::string(row.cause) +
            "\nwhat to do: " + std::string(row.remedy) + "\nothers like it: suture why " +
            std::string(row.page) + "\n";
  }
  return text;
}

}  // namespace

std::string explainError(const std::string& words) {
  for (const auto& [name, page] : errorPages()) {
    if (lettersOf(words) == lettersOf(name)) return std::string(page);
  }
  // The longest text is meant, since one may be part of another.
  std::string_view found, foundText;
  for (const auto& [name, page] : errorPages()) {
    const std::string_view text = textOf(page);
    if (text.size() <= foundText.size() || words.find(text) == std::string::npos) continue;
    found = page;
    foundText = text;
  }
  return found.empty() ? rowsAsText(words) : std::string(found);
}

std::string whatToAsk(const std::string& message) {
  if (message.ends_with('?')) return "";  // it says what to do: "Did you mean"
  const std::vector<Row> rows = rowsOf(message);
  if (rows.empty()) return "";
  return "suture why " + quotedForShell(rows.front().pattern);
}

}  // namespace suture::cli
