#pragma once
// "process:component/interface", or the first of these.

#include <string>
#include <string_view>

namespace suture::cli {

/// What a verb is about. What is not said is empty.
struct Target {
  std::string process, component, interface;

  /// Throws UsageError.
  static Target parse(std::string_view text);
  /// The same, all three said.
  static Target parseInterface(std::string_view text);

  std::string toString() const;
};

}  // namespace suture::cli
