// This is one version of a program of which two processes talk to each other, about every edit of
// the table:
//   edits_peer serve ADDRESS  provides all contracts until its standard input ends
//   edits_peer ask ADDRESS LANE  uses those of the other process, and prints why others cannot be
//   used

#include <suture/component/device.h>

#include <algorithm>
#include <iostream>
#include <string>

#include "tests/compiler/evolution/either_end.h"
#include "tests/support/patience.h"
#include "versioned.h"

namespace edits {
namespace {

using namespace std::chrono_literals;

void print(const std::string& from, const Record& record) {
  forEachMember(record, [&](const char* name, const auto& value) {
    std::cout << from << " " << name << " " << text(value) << "\n";
  });
  std::cout << std::flush;
}

class Keeper final : public suture::EventTask, public Receiver {
 public:
  ~Keeper() override { stop(); }

  const Record& last() const override { return last_; }
  Record exchange(const Record&) override { return last_; }
  void root() override {}
  double depth() const override { return 4; }
  void put(const Record& record) override {
    print("argument", record);
    auto& emit = edits_.emit();
    emitAll(emit);
    emit.rooted(3);
    emit.told(last_);
    emit.end(true);
  }

 private:
  void run() override {}

  Record last_ = example();
  suture::Provided<Edits> edits_{*this, "Edits", *this};
  Kept breaks_{*this};
};

void serve(const std::string& address) {
  Keeper keeper;
  evolution::keep(address, "Keeper", keeper);
}

struct Client final : suture::Device {
  suture::Required<Edits> edits{*this, "Edits"};
  Asked breaks{*this};
};

void tellRefusals(suture::Manager& manager) {
  for (const std::string name : kBreaks) {
    std::string why = "connected";
    try {
      manager.connect("Client/" + name, "server:Keeper/" + name);
    } catch (const suture::SetupError& error) {
      why = error.what();
    }
    std::replace(why.begin(), why.end(), '\n', ' ');
    std::cout << name << ": " << why << std::endl;
  }
}

void printRow(Client& client) {
  Record record;
  const suture::Time deadline = suture::now() + suture::kPatience;
  while (!client.edits.last(record) && suture::now() < deadline) {
    client.waitForEvents(suture::now() + 1ms);
  }
  print("row", record);
  double depth = 0;
  while (!client.edits.depth(depth) && suture::now() < deadline) {
    client.waitForEvents(suture::now() + 1ms);
  }
  std::cout << "row depth " << depth << std::endl;
}

void printEvents(Client& client) {
  bool ended = false;
  hear("told", client.edits.on().told([](const Record& record) { print("event", record); }));
  hear("end", client.edits.on().end([&](bool) { ended = true; }));
  listen(client.edits);
  tell("put", client.edits.put.start(example()));
  const suture::Time deadline = suture::now() + suture::kPatience;
  while (!ended && client.waitForEvents(deadline)) {
    if (!client.processEvents()) break;
  }
}

/// Prints an event that was emitted before a client asked for it: it is known by another word on
/// the wire.
void printLatched(Client& client) {
  bool came = false;
  hear("rooted", client.edits.on().rooted([&](double value) {
    std::cout << "latched " << value << std::endl;
    came = true;
  }));
  const suture::Time deadline = suture::now() + suture::kPatience;
  while (!came && client.waitForEvents(deadline)) {
    if (!client.processEvents()) break;
  }
}

void printAnswer(Client& client) {
  auto call = client.edits.exchange.start(example());
  if (const auto& answer = call.within(suture::kPatience)) {
    print("answer", *answer);
  } else {
    std::cout << "exchange: " << toString(answer.error()) << std::endl;
  }
}

void ask(const evolution::Asking& asking) {
  Client client;
  suture::Manager manager("client", asking.manager);
  manager.add("Client", client);
  manager.start();
  tellRefusals(manager);
  manager.connect("Client/Edits", "server:Keeper/Edits", asking.options);
  printEvents(client);
  printLatched(client);
  printAnswer(client);
  printRow(client);
  call(client.edits);
  manager.stop();
}

}  // namespace
}  // namespace edits

int main(int argc, char** argv) {
  return evolution::eitherEnd(argc, argv, edits::serve, edits::ask);
}
