#pragma once
// This is the provider of `suture-bench network --part sizes`, in a process of its own.

#include <suture/manager/manager.h>

#include <CLI/CLI.hpp>

#include "bench/network/names.h"
#include "bench/table2/processes/child_process.h"

namespace bench {

/// Adds the hidden subcommand that the process runs.
void addBlockProcess(CLI::App& program);

/// Holds the process, the global manager between, and this process's manager. The providers are
/// "server:Small/Blocks", "server:Large/Blocks" and
/// "server:Loans/Blocks", which answers on loan.
class BlockProcess {
 public:
  /// `cpu` is the processor of all of its threads. Throws SetupError.
  BlockProcess(Transport transport, int cpu);
  ~BlockProcess();

  suture::Manager& manager() { return manager_; }

 private:
  const Names names_;
  ChildProcess process_;
  suture::Manager manager_;
};

}  // namespace bench
