#include "cli/text/error_pages.h"

#include <algorithm>
#include <cctype>

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

}  // namespace

std::string_view errorPage(const std::string& words) {
  for (const auto& [name, page] : errorPages()) {
    if (lettersOf(words) == lettersOf(name)) return page;
  }
  // One text may be part of another, so that the longest is meant.
  std::string_view found, foundText;
  for (const auto& [name, page] : errorPages()) {
    const std::string_view text = textOf(page);
    if (text.size() <= foundText.size() || words.find(text) == std::string::npos) continue;
    found = page;
    foundText = text;
  }
  return found;
}

}  // namespace suture::cli
