// One version of a program that keeps samples in files:
//   program write FILE         the version's example; "write-fast" gives it the enumerator that
//   only
//                              the second has
//   program read FILE          prints what this version makes of it
//   program write-choice FILE  the same for a Choice; "write-newest" takes what is newest
//   program read-choice FILE

#include <capnp/message.h>
#include <capnp/serialize.h>
#include <fcntl.h>
#include <suture/base/errors.h>
#include <unistd.h>

#include <iostream>
#include <string>

#include "evolution/choice.capnp.h"
#include "evolution/sample.capnp.h"
#include "tests/compiler/evolution/values.h"

namespace evolution {

void toWire(const SampleSlot& slot, wire::Sample::Builder out);
suture::Errc fromWire(wire::Sample::Reader in, SampleSlot& slot, suture::Duration shift);
void toWire(const ChoiceSlot& slot, wire::Choice::Builder out);
suture::Errc fromWire(wire::Choice::Reader in, ChoiceSlot& slot, suture::Duration shift);

namespace {

void store(capnp::MessageBuilder& message, const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  capnp::writeMessageToFd(file, message);
  ::close(file);
}

void write(const std::string& path, bool fast) {
  capnp::MallocMessageBuilder message;
  SampleSlot slot{};
  store(example(), slot);
  auto sample = message.initRoot<wire::Sample>();
  toWire(slot, sample);
  if (fast) sample.setMode(static_cast<wire::Mode>(2));
  store(message, path);
}

void writeChoice(const std::string& path, bool newest) {
  capnp::MallocMessageBuilder message;
  ChoiceSlot slot{};
  store(exampleChoice(newest), slot);
  toWire(slot, message.initRoot<wire::Choice>());
  store(message, path);
}

int readChoice(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY);
  capnp::StreamFdMessageReader message(file);
  ChoiceSlot slot{};
  const suture::Errc error =
      fromWire(message.getRoot<wire::Choice>(), slot, suture::Duration::zero());
  ::close(file);
  Choice choice;
  if (error == suture::Errc{}) load(slot, choice);
  if (error == suture::Errc{}) print(choice, std::cout);
  std::cout << (error == suture::Errc{} ? "\n" : "refused\n");
  return 0;
}

int read(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY);
  capnp::StreamFdMessageReader message(file);
  SampleSlot slot{};
  const suture::Errc error =
      fromWire(message.getRoot<wire::Sample>(), slot, suture::Duration::zero());
  ::close(file);
  if (error != suture::Errc{}) {
    std::cout << "refused\n";
    return 0;
  }
  Sample sample;
  load(slot, sample);
  std::cout << "count=" << sample.count << " label='" << sample.label << "' values=";
  for (const double value : sample.values) std::cout << value << ",";
  std::cout << " period=" << sample.period.count()
            << " seen=" << sample.seen.time_since_epoch().count() << " pair=" << sample.pair[0]
            << "," << sample.pair[1] << " point=" << sample.point.transpose();
  print(sample, std::cout);
  std::cout << "\n";
  return 0;
}

}  // namespace
}  // namespace evolution

int main(int argc, char** argv) {
  const std::string what = argc == 3 ? argv[1] : "";
  if (what == "read") return evolution::read(argv[2]);
  if (what == "read-choice") return evolution::readChoice(argv[2]);
  if (what == "write" || what == "write-fast") {
    evolution::write(argv[2], what == "write-fast");
  } else if (what == "write-choice" || what == "write-newest") {
    evolution::writeChoice(argv[2], what == "write-newest");
  } else {
    return 2;
  }
}
