// This is one version of a program of which two processes talk to each other:
//   peer serve ADDRESS  provides Feed until its standard input ends, and prints what it gets
//   peer ask ADDRESS LANE  uses the Feed of the other process by that lane, and prints what it gets

#include <suture/component/device.h>

#include <iostream>
#include <string>
#include <thread>

#include "feeder.h"
#include "tests/compiler/evolution/either_end.h"
#include "tests/support/patience.h"

namespace evolution {
namespace {

using namespace std::chrono_literals;

struct Client final : suture::Device {
  suture::Required<Feed> feed{*this, "Feed"};
};

void serve(const std::string& address) {
  Feeder feeder;
  keep(address, "Feeder", feeder);
}

std::string modeOf(Client& client) {
  const suture::Time deadline = suture::now() + suture::kPatience;
  for (;;) {
    const auto mode = client.feed.mode();
    if (mode) return *mode == Mode::On ? "On" : "another";
    if (suture::now() >= deadline) return toString(mode.error());
    std::this_thread::sleep_for(1ms);
  }
}

void talk(Client& client) {
  auto moved = client.feed.on().moved.next();
  const auto put = startPut(client.feed).within(suture::kPatience);
  std::cout << "put: " << (put ? "done" : toString(put.error())) << "\n";
  if (const auto& sample = moved.within(suture::kPatience)) {
    std::cout << "moved label='" << sample->label << "'";
    print(*sample, std::cout);
    std::cout << "\n";
  } else {
    std::cout << "moved: " << toString(sample.error()) << "\n";
  }
  std::cout << "mode: " << modeOf(client) << "\n";
  tryNewest(client.feed);
}

void ask(const Asking& asking) {
  Client client;
  connected(asking, client, "Feed", "Feeder/Feed", [&] { talk(client); });
}

}  // namespace
}  // namespace evolution

int main(int argc, char** argv) {
  return evolution::eitherEnd(argc, argv, evolution::serve, evolution::ask);
}
