#pragma once
// This is the provider of `suture-bench network`, in a process of its own.

#include <suture/manager/manager.h>

#include <CLI/CLI.hpp>

#include "bench/network/names.h"
#include "bench/table2/processes/child_process.h"

namespace bench {

/// Adds the hidden subcommand that the process runs.
void addSampleProcess(CLI::App& program);

/// Holds the process, the global manager between, and this process's manager. The provider is
/// "server:Server/Samples".
class SampleProcess {
 public:
  /// `serverCpu` is the processor of all of its threads. Throws SetupError.
  SampleProcess(Transport transport, int serverCpu);
  ~SampleProcess();

  suture::Manager& manager() { return manager_; }
  const Names& names() const { return names_; }
  pid_t pid() const { return process_.pid(); }
  /// Says that it has been killed or stopped: nothing is expected of it any more.
  void abandon() { abandoned_ = true; }

 private:
  bool abandoned_ = false;
  const Names names_;
  ChildProcess process_;
  suture::Manager manager_;
};

}  // namespace bench
