#include "tests/compiler/evolution/values.h"

#include <string>

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

Choice exampleChoice(bool newest) {
  Choice choice;
  if (newest) choice.value = std::int32_t{7};
  if (!newest) choice.value = true;
  choice.inner.x = 4;
  choice.pace = Pace::Quick;
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
