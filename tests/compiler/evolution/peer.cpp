// One version of a program of which two processes talk to each other:
//   peer serve ADDRESS  provides Feed until its standard input ends, and prints what it gets
//   peer ask ADDRESS    uses the Feed of the other process, and prints what it gets

#include <suture/base/errors.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include <iostream>
#include <string>
#include <thread>

#include "feeder.h"

namespace evolution {
namespace {

using namespace std::chrono_literals;

struct Client final : suture::Device {
  suture::Required<Feed> feed{*this, "Feed"};
};

void serve(const std::string& address) {
  Feeder feeder;
  suture::Manager manager("server", address);
  manager.add("Feeder", feeder);
  manager.start();
  std::cout << "ready" << std::endl;
  std::cin.get();
  manager.stop();
}

std::string modeOf(Client& client) {
  const suture::Time deadline = suture::now() + 5s;
  for (;;) {
    const auto mode = client.feed.mode();
    if (mode) return *mode == Mode::On ? "On" : "another";
    if (suture::now() >= deadline) return toString(mode.error());
    std::this_thread::sleep_for(1ms);
  }
}

void ask(const std::string& address) {
  Client client;
  suture::Manager manager("client", address);
  manager.add("Client", client);
  manager.start();
  manager.connect("Client/Feed", "server:Feeder/Feed");
  auto moved = client.feed.on().moved.next();
  const auto put = startPut(client.feed).within(5s);
  std::cout << "put: " << (put ? "done" : toString(put.error())) << "\n";
  if (const auto& sample = moved.within(5s)) {
    std::cout << "moved label='" << sample->label << "'";
    print(*sample, std::cout);
    std::cout << "\n";
  } else {
    std::cout << "moved: " << toString(sample.error()) << "\n";
  }
  std::cout << "mode: " << modeOf(client) << "\n";
  tryNewest(client.feed);
  manager.stop();
}

}  // namespace
}  // namespace evolution

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    if (std::string(argv[1]) == "serve") {
      evolution::serve(argv[2]);
    } else {
      evolution::ask(argv[2]);
    }
  } catch (const suture::SetupError& error) {
    std::cout << error.what() << std::endl;
    return 1;
  }
}
