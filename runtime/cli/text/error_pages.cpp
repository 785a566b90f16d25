#include "cli/text/error_pages.h"

#include <algorithm>
#include <cctype>
#include <sstream>
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

/// Tells if `words` have the parts of "`it is still ...`", one behind the other.
bool hasParts(std::string_view words, std::string_view found) {
  constexpr std::string_view kAny = "...";
  found = found.substr(1, found.size() - 2);  // without its quotes
  while (!found.empty()) {
    const std::size_t end = std::min(found.find(kAny), found.size());
    const std::size_t at = words.find(found.substr(0, end));
    if (at == std::string_view::npos) return false;
    words.remove_prefix(at + end);
    found.remove_prefix(std::min(end + kAny.size(), found.size()));
  }
  return true;
}

std::string setUpError(const std::string& words) {
  const auto page = errorPages().find("set-up");
  if (page == errorPages().end()) return "";
  std::string text;
  std::istringstream lines{std::string(page->second)};
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| `")) continue;
    const auto cells = cellsOf(line);
    if (cells.size() != 3 || !hasParts(words, cells[0])) continue;
    text += "why it happens: " + std::string(cells[1]) + "\nwhat to do: " + std::string(cells[2]) +
            "\n";
  }
  return text;
}

}  // namespace

std::string explainError(const std::string& words) {
  for (const auto& [name, page] : errorPages()) {
    if (lettersOf(words) == lettersOf(name)) return std::string(page);
  }
  // One text may be part of another, so that the longest is meant.
  std::string_view found, foundText;
  for (const auto& [name, page] : errorPages()) {
    const std::string_view text = textOf(page);
    if (text.size() <= foundText.size() || words.find(text) == std::string::npos) continue;
    found = page;
    foundText = text;
  }
  return found.empty() ? setUpError(words) : std::string(found);
}

}  // namespace suture::cli
