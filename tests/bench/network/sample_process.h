#pragma once
// The provider of `suture-bench network`, in a process of its own.

#include <suture/manager/global_manager.h>
#include <suture/manager/manager.h>
#include <suture/transport/rpc/control_thread.h>
#include <CLI/CLI.hpp>

#include "bench/table2/child_process.h"
#include "bench/table2/setup.h"
#include "support/temporary_directory.h"

namespace bench {

/// Adds the hidden subcommand that the process runs.
void addSampleProcess(CLI::App& program);

/// The process, the global manager between, and this process's manager. The provider is
/// "server:Server/Samples".
class SampleProcess {
 public:
  /// `serverCpu`: of all of its threads. Throws SetupError.
  SampleProcess(Transport transport, int serverCpu);
  ~SampleProcess();

  suture::Manager& manager() { return manager_; }

 private:
  const suture::TemporaryDirectory folder_;
  suture::rpc::ControlThread control_;
  const suture::GlobalManager names_;
  ChildProcess process_;
  suture::Manager manager_;
};

}  // namespace bench
