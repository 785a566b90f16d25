#pragma once
// Writes Markdown as GitHub reads it.

#include <string>
#include <string_view>
#include <vector>

namespace suture::compiler::emit {

/// Writes a table without the columns that are empty in every row.
class MarkdownTable {
 public:
  explicit MarkdownTable(std::vector<std::string> titles) : titles_(std::move(titles)) {}

  /// Adds a row, which has as many cells as there are titles.
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  /// Returns the table with a blank line behind it; "" without rows.
  std::string text() const;

 private:
  std::string line(const std::vector<std::string>& cells) const;
  bool isUsed(std::size_t column) const;

  std::vector<std::string> titles_;
  std::vector<std::vector<std::string>> rows_;
};

/// Returns "`text`".
std::string inCode(std::string_view text);

/// Returns text that people wrote so that what looks like HTML outside of code reads as it was
/// written.
std::string prose(std::string_view text);

/// Returns the text's first sentence, on one line.
std::string firstSentence(std::string_view text);

/// Returns where the heading can be linked to: "Arm::moved (event)" -> "#armmoved-event".
std::string anchorOf(std::string_view heading);

/// Returns "[text](target)".
std::string link(std::string_view text, std::string_view target);

}  // namespace suture::compiler::emit
