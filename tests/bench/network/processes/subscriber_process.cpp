#include "bench/network/processes/subscriber_process.h"

#include <suture/component/task/event_task.h>
#include <suture/manager/manager.h>

#include <cstdint>
#include <deque>
#include <memory>
#include <span>

#include "bench/network/lanes.h"
#include "bench/sample_loop.suture.h"
#include "bench/table2/processes/child_process.h"

namespace bench {
namespace {

constexpr const char* kSubscriberSubcommand = "network-subscribers";

std::string nameOf(std::size_t interface) { return "Server" + std::to_string(interface); }

class Subscribers final : public suture::EventTask {
 public:
  Subscribers(std::size_t interfaces, std::size_t samples) {
    ages_.reserve(samples);
    for (std::size_t i = 0; i < interfaces; ++i) {
      servers_.emplace_back(*this, nameOf(i)).on().echo([this](const robots::PoseSample& value) {
        if ((value.flags & kMeasured) == 0 || ages_.size() == ages_.capacity()) return;
        ages_.push_back((suture::now() - value.stamp).count());
      });
    }
  }
  ~Subscribers() override { stop(); }

  void run() override {}
  /// Returns the ages, ns, once the task has been stopped.
  std::span<const std::int64_t> ages() const { return ages_; }

 private:
  std::deque<suture::Required<SampleServer>> servers_;
  std::vector<std::int64_t> ages_;
};

void subscribe(const SubscriberSetup& setup) {
  Subscribers subscribers(setup.interfaces, setup.samples);
  suture::Manager manager{setup.process, setup.manager};
  manager.add("Subscribers", subscribers);
  manager.start();
  for (std::size_t i = 0; i < setup.interfaces; ++i) {
    connectBy(setup.lane, manager, "Subscribers/" + nameOf(i), "sender:Sender/Samples");
  }
  awaitEndOfInput();
  manager.stop();
  writeResult(subscribers.ages());
}

}  // namespace

void addSubscriberProcess(CLI::App& program) {
  struct Options {
    SubscriberSetup setup;
    std::string lane;
  };
  auto options = std::make_shared<Options>();
  CLI::App* process = program.add_subcommand(kSubscriberSubcommand, "the subscribers of a fan-out");
  process->group("");  // hidden
  process->add_option("--process", options->setup.process)->required();
  process->add_option("--manager", options->setup.manager)->required();
  process->add_option("--lane", options->lane)->required();
  process->add_option("--interfaces", options->setup.interfaces)->required();
  process->add_option("--samples", options->setup.samples)->required();
  process->callback([options] {
    options->setup.lane = {options->lane};
    subscribe(options->setup);
  });
}

std::vector<std::string> subscriberProcessArguments(const SubscriberSetup& setup) {
  return {kSubscriberSubcommand,
          "--process",
          setup.process,
          "--manager",
          setup.manager,
          "--lane",
          suture::toString(setup.lane),
          "--interfaces",
          std::to_string(setup.interfaces),
          "--samples",
          std::to_string(setup.samples)};
}

}  // namespace bench
