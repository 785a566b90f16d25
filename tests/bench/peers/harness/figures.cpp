#include "harness/figures.h"

#include <cstdio>

namespace peers {

Figures& Figures::add(const std::string& name, double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", value);
  return addText(name, text);
}

Figures& Figures::add(const std::string& name, const std::string& words) {
  return addText(name, '"' + words + '"');
}

Figures& Figures::add(const Statistics& statistics) {
  return add("minimum", statistics.minimum)
      .add("median", statistics.median)
      .add("p99", statistics.p99)
      .add("p99_9", statistics.p999)
      .add("maximum", statistics.maximum);
}

Figures& Figures::addText(const std::string& name, const std::string& value) {
  text_ += (text_.empty() ? "\"" : ", \"") + name + "\": " + value;
  return *this;
}

void Figures::print() const {
  std::printf("{%s}\n", text_.c_str());
  std::fflush(stdout);
}

}  // namespace peers
