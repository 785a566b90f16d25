#pragma once
// This is "process:component/interface", or the first of these.

#include <string>
#include <string_view>

namespace suture::cli {

/// A Target is the subject of a verb. A part that was not said is empty.
struct Target {
  std::string process, component, interface;

  /// Throws UsageError.
  static Target parse(std::string_view text);
  /// Does the same, but requires all three.
  static Target parseInterface(std::string_view text);

  std::string toString() const;
};

}  // namespace suture::cli
