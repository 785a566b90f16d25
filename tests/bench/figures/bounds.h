#pragma once
// The figures must keep to these: bounds.txt, compiled in.

#include <string>
#include <string_view>
#include <vector>

#include "bench/figures/report.h"

namespace bench {

/// A Bound is one line of bounds.txt.
struct Bound {
  std::string subcommand;
  std::string figure;
  bool atMost = true;  ///< else at least
  double limit = 0;
  std::string unit;
  std::string words;
};

/// Reads the form that bounds.txt explains. Throws std::runtime_error that names the line.
std::vector<Bound> parseBounds(std::string_view text);

/// Returns the text of bounds.txt as it was when this program was built.
std::string_view boundsText();

/// Returns what falls short, a line each for people: figures beyond their bound, and figures that
/// have a bound and no value.
std::vector<std::string> shortfalls(const std::vector<Bound>& bounds, const std::string& subcommand,
                                    const Report& report);

}  // namespace bench
