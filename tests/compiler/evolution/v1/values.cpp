#include "tests/compiler/evolution/values.h"

namespace evolution {

Sample example() {
  Sample sample;
  sample.x = 1.5;
  sample.count = -3;
  sample.label = "first";
  sample.values = {1, 2};
  sample.mode = Mode::On;
  sample.period = std::chrono::milliseconds(20);
  sample.seen = suture::fromNanoseconds(99);
  sample.pair = {0.5f, -1};
  sample.point = {4, 5, 6};
  sample.gone = 8;
  return sample;
}

void print(const Sample& sample, std::ostream& out) {
  out << " x=" << sample.x << " gone=" << sample.gone
      << " mode=" << (sample.mode == Mode::On ? "On" : "Off");
}

}  // namespace evolution
