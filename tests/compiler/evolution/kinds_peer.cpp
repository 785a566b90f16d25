// This is one version of a program of which two processes talk to each other, about every kind of
// type:
//   kinds_peer serve ADDRESS  provides Kinds until its standard input ends
//   kinds_peer ask ADDRESS    uses the Kinds of the other process
// Each prints a line for every member that it gets: where it came from, its name, its value.

#include <suture/component/device.h>

#include <iostream>
#include <string>

#include "tests/compiler/evolution/either_end.h"
#include "tests/support/patience.h"
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
  // Members that nothing initialises are 0 in static memory; elsewhere they are whatever it held.
  static Keeper keeper;
  keep(address, "Keeper", keeper);
}

struct Client final : suture::Device {
  suture::Required<Kinds> kinds{*this, "Kinds"};
};

void printRow(Client& client) {
  Record record;
  const suture::Time deadline = suture::now() + suture::kPatience;
  while (!client.kinds.last(record) && suture::now() < deadline) {
    client.waitForEvents(suture::now() + 1ms);
  }
  print("row", record);
}

void talk(Client& client) {
  bool told = false;
  const auto subscribed = client.kinds.on().put([&](const Record& record) {
    print("event", record);
    told = true;
  });
  if (!subscribed) std::cout << "on put: " << toString(subscribed.error()) << "\n";
  Record record;
  record.x = 2.5;
  const auto put = startPut(client.kinds, record).within(suture::kPatience);
  std::cout << "put: " << (put ? "done" : toString(put.error())) << "\n";
  const suture::Time deadline = suture::now() + suture::kPatience;
  while (!told && client.waitForEvents(deadline)) {
    if (!client.processEvents()) break;
  }
  printRow(client);
}

void ask(const Asking& asking) {
  Client client;
  connected(asking, client, "Kinds", "Keeper/Kinds", [&] { talk(client); });
}

}  // namespace
}  // namespace evolution

int main(int argc, char** argv) {
  return evolution::eitherEnd(argc, argv, evolution::serve, evolution::ask);
}
