// One version of a program of which two processes talk to each other, about every kind of type:
//   kinds_peer serve ADDRESS  provides Kinds until its standard input ends
//   kinds_peer ask ADDRESS    uses the Kinds of the other process
// Each prints a line for every member that it gets: where it came from, its name, its value.

#include <suture/base/errors.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include <iostream>
#include <string>

#include "versioned.h"

namespace evolution {
namespace {

using namespace std::chrono_literals;

void print(const std::string& from, const Record& record) {
  const auto line = [&](const char* name, const auto& value) {
    std::cout << from << " " << name << " " << text(value) << "\n";
  };
  line("x", record.x);
  forEachAdded(record, line);
  std::cout << std::flush;
}

class Keeper final : public suture::Device, public Receiver {
 public:
  Keeper() { last_.x = 1.5; }

  const Record& last() const override { return last_; }
  void received(const Record& record) override {
    print("argument", record);
    kinds_.emit().put(record);
  }
  void received(const std::string& name, const std::string& value) override {
    std::cout << "parameter " << name << " " << value << std::endl;
  }

 private:
  Record last_;
  suture::Provided<Kinds> kinds_{*this, "Kinds", *this};
};

void serve(const std::string& address) {
  Keeper keeper;
  suture::Manager manager("server", address);
  manager.add("Keeper", keeper);
  manager.start();
  std::cout << "ready" << std::endl;
  std::cin.get();
  manager.stop();
}

struct Client final : suture::Device {
  suture::Required<Kinds> kinds{*this, "Kinds"};
};

void printRow(Client& client) {
  Record record;
  const suture::Time deadline = suture::now() + 10s;
  while (!client.kinds.last(record) && suture::now() < deadline) {
    client.waitForEvents(suture::now() + 1ms);
  }
  print("row", record);
}

void ask(const std::string& address) {
  Client client;
  suture::Manager manager("client", address);
  manager.add("Client", client);
  manager.start();
  manager.connect("Client/Kinds", "server:Keeper/Kinds");
  bool told = false;
  const auto subscribed = client.kinds.on().put([&](const Record& record) {
    print("event", record);
    told = true;
  });
  if (!subscribed) std::cout << "on put: " << toString(subscribed.error()) << "\n";
  Record record;
  record.x = 2.5;
  const auto put = startPut(client.kinds, record).within(10s);
  std::cout << "put: " << (put ? "done" : toString(put.error())) << "\n";
  const suture::Time deadline = suture::now() + 10s;
  while (!told && client.waitForEvents(deadline)) {
    if (!client.processEvents()) break;
  }
  printRow(client);
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
