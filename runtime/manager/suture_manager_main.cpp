// suture-manager: the global manager as a process of its own.

#include <suture/base/errors.h>
#include <suture/manager/global_manager.h>
#include <suture/transport/rpc/control_thread.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>

namespace {

/// Blocks the signals that end the program, in this thread and those it starts.
sigset_t blockEndSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

void serve(const std::string& address) {
  const sigset_t signals = blockEndSignals();
  suture::GlobalManager::makeDirectory(address);
  suture::rpc::ControlThread control;
  const suture::GlobalManager manager(control, address);
  std::printf("suture-manager: ready on %s\n", manager.address().c_str());
  std::fflush(stdout);
  int received = 0;
  sigwait(&signals, &received);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Knows the names of the processes of a Suture system, so that they find each other."};
  std::string address = suture::GlobalManager::defaultAddress();
  app.add_option("--listen", address, "unix:/path or tcp://127.0.0.1:port; port 0 picks one")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    serve(address);
  } catch (const suture::SetupError& error) {
    std::fprintf(stderr, "suture-manager: %s\n", error.what());
    return 1;
  }
  return 0;
}
