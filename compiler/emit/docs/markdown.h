#pragma once
// Writes Markdown as GitHub reads it.

#include <string>
#include <string_view>
#include <vector>

namespace suture::compiler::emit {

/// A table without the columns that are empty in every row.
class MarkdownTable {
 public:
  explicit MarkdownTable(std::vector<std::string> titles) : titles_(std::move(titles)) {}

  /// As many cells as there are titles.
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  /// With a blank line behind it; "" without rows.
  std::string text() const;

 private:
  std::string line(const std::vector<std::string>& cells) const;
  bool isUsed(std::size_t column) const;

  std::vector<std::string> titles_;
  std::vector<std::vector<std::string>> rows_;
};

/// "`text`".
std::string inCode(std::string_view text);

/// Text that people wrote: what looks like HTML outside of code reads as it was written.
std::string prose(std::string_view text);

/// Its first sentence, on one line.
std::string firstSentence(std::string_view text);

/// Where the heading can be linked to: "Arm::moved (event)" -> "#armmoved-event".
std::string anchorOf(std::string_view heading);

/// "[text](target)".
std::string link(std::string_view text, std::string_view target);

}  // namespace suture::compiler::emit
