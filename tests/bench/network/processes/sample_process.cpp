#include "bench/network/processes/sample_process.h"

#include <memory>

#include "bench/local/sample_server.h"
#include "bench/network/lanes.h"
#include "bench/placement.h"

namespace bench {
namespace {

constexpr const char* kSampleSubcommand = "network-server";

struct SampleProcessOptions {
  std::string manager, keys;
  int cpu = 0;
};

void serve(const SampleProcessOptions& options) {
  const Pinned pinned(options.cpu);
  SampleTask server(options.cpu);
  suture::Manager manager{"server", options.manager, securityWith(options.keys, "server")};
  addEncodedFrames(manager);
  manager.add("Server", server);
  manager.start();
  awaitEndOfInput();
  manager.stop();
}

}  // namespace

void addSampleProcess(CLI::App& program) {
  auto options = std::make_shared<SampleProcessOptions>();
  CLI::App* process = program.add_subcommand(kSampleSubcommand, "the server process of a loop");
  process->group("");  // hidden
  process->add_option("--manager", options->manager)->required();
  process->add_option("--keys", options->keys)->required();
  process->add_option("--cpu", options->cpu)->required();
  process->callback([options] { serve(*options); });
}

SampleProcess::SampleProcess(Transport transport, int serverCpu)
    : names_(transport),
      process_({kSampleSubcommand, "--manager", names_.address(), "--keys", names_.keys(), "--cpu",
                std::to_string(serverCpu)}),
      manager_("client", names_.address(), securityWith(names_.keys(), "client")) {
  addEncodedFrames(manager_);
}

SampleProcess::~SampleProcess() {
  manager_.stop();
  if (!abandoned_) process_.finish();
}

}  // namespace bench
