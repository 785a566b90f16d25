#include "tests/compiler/evolution/values.h"

#include <string>

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

Choice exampleChoice(bool newest) {
  Choice choice;
  choice.value = newest ? std::variant<double, bool>(true) : 1.5;
  choice.second = 2.5;
  choice.inner.x = 3;
  choice.pace = Pace::Fast;
  return choice;
}

void print(const Choice& choice, std::ostream& out) {
  out << "value=" << std::visit([](auto value) { return std::to_string(value); }, choice.value)
      << " second=";
  if (choice.second) {
    std::visit([&](auto value) { out << value; }, *choice.second);
  } else {
    out << "none";
  }
  out << " x=" << choice.inner.x << " pace=" << (choice.pace == Pace::Slow ? "slow" : "fast");
}

}  // namespace evolution
