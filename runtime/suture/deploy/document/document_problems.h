#pragma once
// This collects what is wrong with a document, so that all of it is told at once.

#include <suture/deploy/document/json_document.h>

#include <string>
#include <vector>

namespace suture {

/// Set-up code only. The document outlives it.
class DocumentProblems {
 public:
  explicit DocumentProblems(const JsonDocument& document) : document_(document) {}

  void report(const std::string& pointer, const std::string& text) {
    found_.push_back(document_.locate(pointer, text));
  }
  std::size_t count() const { return found_.size(); }
  const std::vector<std::string>& found() const { return found_; }
  /// Throws DocumentError if there is any.
  void throwIfAny() const {
    if (!found_.empty()) throw DocumentError(found_);
  }

 private:
  const JsonDocument& document_;
  std::vector<std::string> found_;
};

}  // namespace suture
