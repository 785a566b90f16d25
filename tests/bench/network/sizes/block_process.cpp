#include "bench/network/sizes/block_process.h"

#include <suture/component/task/event_task.h>

#include <memory>

#include "bench/network/sizes/block_loan.h"
#include "bench/placement.h"

namespace bench {
namespace {

constexpr const char* kBlockSubcommand = "block-server";

template <class Contract>
class BlockTask final : public suture::EventTask, public Contract {
 public:
  BlockTask(int cpu, bool onLoan)
      : EventTask({.scheduling = {.processor = cpu}}), onLoan_(onLoan) {}
  ~BlockTask() override { stop(); }

  void bounce(const typename Contract::Block& block) override {
    auto& event = provided_.emit().echo;
    if (onLoan_) {
      event.template loan<kBytes<Contract>>({}, copyOf(block.bytes));
    } else {
      event(block);
    }
  }
  void run() override {}

 private:
  const bool onLoan_;
  suture::Provided<Contract> provided_{*this, "Blocks", *this};
};

struct BlockProcessOptions {
  std::string manager;
  int cpu = 0;
};

void serve(const BlockProcessOptions& options) {
  const Pinned pinned(options.cpu);
  BlockTask<SmallBlocks> small(options.cpu, false);
  BlockTask<LargeBlocks> large(options.cpu, false), loans(options.cpu, true);
  suture::Manager manager{"server", options.manager};
  manager.add("Small", small);
  manager.add("Large", large);
  manager.add("Loans", loans);
  manager.start();
  awaitEndOfInput();
  manager.stop();
}

}  // namespace

void addBlockProcess(CLI::App& program) {
  auto options = std::make_shared<BlockProcessOptions>();
  CLI::App* process = program.add_subcommand(kBlockSubcommand, "the server process of blocks");
  process->group("");  // hidden
  process->add_option("--manager", options->manager)->required();
  process->add_option("--cpu", options->cpu)->required();
  process->callback([options] { serve(*options); });
}

BlockProcess::BlockProcess(Transport transport, int cpu)
    : names_(transport),
      process_({kBlockSubcommand, "--manager", names_.address(), "--cpu", std::to_string(cpu)}),
      manager_("client", names_.address()) {}

BlockProcess::~BlockProcess() {
  manager_.stop();
  process_.finish();
}

}  // namespace bench
