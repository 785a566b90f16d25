#include <suture/base/errors.h>
#include <suture/component/device.h>
#include <suture/wiring/connect.h>

#include <deque>

#include "bench/figures/table.h"
#include "bench/local/rows.h"
#include "bench/local/sample_device.h"
#include "bench/local/sample_server.h"
#include "bench/placement.h"
#include "bench/timed_loops.h"

namespace bench {
namespace {

constexpr std::size_t kSubscribers = 64;
constexpr std::size_t kEvents = 16;  // all that a subscriber's queue takes

/// Emits kEvents when it is bounced and measures them.
class BurstSender final : public suture::EventTask, public SampleServer {
 public:
  BurstSender(int cpu, std::size_t rounds) : EventTask({.scheduling = {.processor = cpu}}) {
    costs_.reserve(rounds);
  }
  ~BurstSender() override { stop(); }

  void put(const robots::PoseSample&) override {}
  void bounce(const robots::PoseSample& value) override {
    const double begin = threadTime();
    for (std::size_t i = 0; i < kEvents; ++i) provided_.emit().echo(value);
    costs_.push_back((threadTime() - begin) / (kEvents * kSubscribers));
  }
  robots::PoseSample value() const override { return {}; }
  void run() override {}

  suture::ProvidedBase& provided() { return provided_; }
  /// Returns ns an event and subscriber, a sample a round, once the task has been stopped.
  const std::vector<double>& costs() const { return costs_; }

 private:
  suture::Provided<SampleServer> provided_{*this, "Samples", *this};
  std::vector<double> costs_;
};

struct Subscriber final : suture::Device {
  Subscriber() {
    server.on().echo([this](const robots::PoseSample&) { ++received; });
  }
  suture::Required<SampleServer> server{*this, "Server"};
  std::size_t received = 0;
};

void require(std::size_t wanted, std::size_t received) {
  if (received == wanted) return;
  throw suture::SetupError(std::to_string(wanted) + " events at the subscribers",
                           std::to_string(received) + " arrived",
                           "The cost of those would not be that of events");
}

std::vector<double> measureEvents(const LocalOptions& options) {
  const Pinned pinned(options.cpu);
  const std::size_t rounds = options.count(20'000);
  BurstSender sender(options.cpu, rounds);
  std::deque<Subscriber> subscribers(kSubscribers);
  for (Subscriber& one : subscribers)
    suture::connectLocally(one.server, sender.provided(), "bench");
  SampleDevice controller;
  suture::connectLocally(controller.server, sender.provided(), "bench");
  sender.start();
  const auto emitOnce = [&] {
    if (!controller.server.bounce.start(poseSample()).within()) {
      throw suture::SetupError("a round of events", "no answer of the sender", "Run it again");
    }
    for (Subscriber& one : subscribers) one.processEvents();
  };
  emitOnce();  // some join only now
  for (Subscriber& one : subscribers) one.received = 0;
  for (std::size_t round = 0; round < rounds; ++round) emitOnce();
  sender.stop();
  std::size_t received = 0;
  for (const Subscriber& one : subscribers) received += one.received;
  require(rounds * kEvents * kSubscribers, received);
  return {sender.costs().begin() + 1, sender.costs().end()};
}

}  // namespace

std::string fanOutRow(const LocalOptions& options, Report& report) {
  const Statistics cost = statisticsOf(measureEvents(options));
  report.add("fan_out", "ns", cost);
  Table table(1);
  table.row(joined({"ns a subscriber, in the sender"}, statisticsTitles()));
  table.line();
  table.row(joined({"event to 64 subscribers, doorbells apart"}, cellsOf(cost, 1)));
  return table.toString();
}

}  // namespace bench
