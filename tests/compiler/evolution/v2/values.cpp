#include "tests/compiler/evolution/values.h"

namespace evolution {

Sample example() {
  Sample sample;
  sample.weight = 3;
  sample.count = 11;
  sample.label = "second";
  sample.mode = Mode::Off;
  sample.period = std::chrono::milliseconds(30);
  sample.values = {7};
  sample.seen = suture::fromNanoseconds(11);
  sample.east = -2.5;
  sample.pair = {2, 3};
  sample.point = {7, 8, 9};
  sample.note = "new";
  return sample;
}

void print(const Sample& sample, std::ostream& out) {
  out << " east=" << sample.east << " weight=" << sample.weight << " note='" << sample.note
      << "' mode="
      << (sample.mode == Mode::On    ? "On"
          : sample.mode == Mode::Off ? "Off"
                                     : "Fast");
}

}  // namespace evolution
