#pragma once

#include <string>

#include "harness/statistics.h"

namespace peers {

/// Prints figures with their names as one line of JSON, which the report reads.
class Figures {
 public:
  Figures& add(const std::string& name, double value);
  Figures& add(const std::string& name, const std::string& words);
  /// Adds the minimum, the median and so on, each under its name.
  Figures& add(const Statistics& statistics);

  void print() const;

 private:
  Figures& addText(const std::string& name, const std::string& value);

  std::string text_;
};

}  // namespace peers
