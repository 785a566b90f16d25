#include "bench/table2/processes/server_process.h"

#include <net/if.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <memory>
#include <thread>

#include "bench/placement.h"
#include "bench/table2/processes/child_process.h"
#include "bench/table2/processes/server.h"
#include "support/cable.h"

namespace bench {
namespace {

constexpr const char* kServerSubcommand = "table2-server";

struct ServerProcessOptions {
  std::string manager;
  LoopSetup setup;
  bool periodic = false;
  std::int64_t periodNanoseconds = 0;
  int fifo = 0;
  int cpu = -1;
  bool apart = false;  // in a network namespace of its own, at the other end of a cable
};

/// Leaves for a network namespace, and waits for the cable to come there.
void moveApart() {
  suture::Cable::leave();
  while (if_nametoindex("there") == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  suture::Cable::plugIn();
}

void serve(ServerProcessOptions options) {
  if (options.apart) moveApart();
  LoopSetup& setup = options.setup;
  setup.pace = options.periodic ? Pace::Periodic : Pace::EventDriven;
  setup.period = suture::Duration(options.periodNanoseconds);
  if (options.fifo > 0) {
    setup.scheduling.policy = suture::rt::Policy::Fifo;
    setup.scheduling.priority = options.fifo;
  }
  if (options.cpu >= 0) setup.scheduling.processor = options.cpu;

  const Pinned pinned(setup.scheduling.processor);
  const auto server = makeServer(setup);
  suture::Manager manager{"server", options.manager};
  manager.add("Server", server->task());
  manager.start();
  awaitEndOfInput();
  manager.stop();
  writeResult(std::span(server->elapsed()));
}

}  // namespace

void addServerProcess(CLI::App& program) {
  auto options = std::make_shared<ServerProcessOptions>();
  CLI::App* process = program.add_subcommand(kServerSubcommand, "the server process of a loop");
  process->group("");  // hidden
  process->add_option("--manager", options->manager)->required();
  process->add_flag("--periodic", options->periodic);
  process->add_option("--period-ns", options->periodNanoseconds)->required();
  process->add_option("--fifo", options->fifo);
  process->add_option("--cpu", options->cpu);
  process->add_flag("--apart", options->apart);
  process->add_option("--skip", options->setup.skip);
  process->add_option("--samples", options->setup.samples);
  process->callback([options] { serve(*options); });
}

std::vector<std::string> serverProcessArguments(const LoopSetup& setup,
                                                const std::string& managerAddress, bool apart) {
  std::vector<std::string> arguments{kServerSubcommand,
                                     "--manager",
                                     managerAddress,
                                     "--period-ns",
                                     std::to_string(setup.period.count()),
                                     "--skip",
                                     std::to_string(setup.skip),
                                     "--samples",
                                     std::to_string(setup.samples)};
  if (apart) arguments.emplace_back("--apart");
  if (setup.pace == Pace::Periodic) arguments.emplace_back("--periodic");
  if (setup.scheduling.policy == suture::rt::Policy::Fifo) {
    arguments.insert(arguments.end(), {"--fifo", std::to_string(setup.scheduling.priority)});
  }
  if (const auto cpu = setup.scheduling.processor) {
    arguments.insert(arguments.end(), {"--cpu", std::to_string(*cpu)});
  }
  return arguments;
}

}  // namespace bench
