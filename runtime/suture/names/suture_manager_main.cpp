// suture-manager is the global manager as its own process.

#include <suture/base/errors.h>
#include <suture/base/plain.h>
#include <suture/loop/control_thread.h>
#include <suture/loop/descriptor_limit.h>
#include <suture/loop/signal_wait.h>
#include <suture/loop/standard_streams.h>
#include <suture/names/global_manager.h>
#include <suture/net/tls/keys.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace {

constexpr int kFailed = 1, kMisused = 2;  // exit status

struct Options {
  std::string address = suture::GlobalManager::defaultAddress();
  std::string keys;
  std::vector<unsigned> users;
};

suture::Security securityOf(const Options& options) {
  suture::Security security;
  if (!options.keys.empty()) {
    const auto keys =
        std::make_shared<const suture::tls::Keys>(options.keys, suture::tls::kManagerName);
    if (!keys->warning().empty()) {
      std::fprintf(stderr, "suture-manager: warning: %s\n", keys->warning().c_str());
    }
    security.keys = keys;
  }
  if (options.users.empty()) return security;
  std::vector<suture::Rule> rules{{"user:same", {}}, {"process:*", {}}, {"tcp", {}}};
  for (const unsigned user : options.users) rules.push_back({"user:" + std::to_string(user), {}});
  security.policy = suture::Policy(rules);
  return security;
}

void serve(const Options& options) {
  const suture::loop::SignalWait toldToEnd;
  suture::GlobalManager::makeDirectory(options.address);
  suture::loop::ControlThread control;
  const suture::GlobalManager manager(control, options.address, securityOf(options));
  std::printf("suture-manager: ready on %s\n", manager.address().c_str());
  std::fflush(stdout);
  (void)toldToEnd.endBefore(suture::Time::max());
}

int help(const CLI::App& app, const CLI::ParseError& asked) {
  std::ostringstream text;
  const int status = app.exit(asked, text, text);
  suture::loop::writeOut(text.str());
  return status;
}

/// Returns the exit status.
int run(CLI::App& app, const Options& options, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return help(app, error);
    app.exit(error);
    return kMisused;
  }
  serve(options);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  suture::loop::openStandardDescriptors();
  suture::loop::allowAllDescriptors();
  CLI::App app{
      "Knows the names of the processes of a Suture system, so that they find each other."};
  Options options;
  app.add_option("--listen", options.address,
                 "unix:/path, tls://host:port or tcp://127.0.0.1:port; port 0 picks one")
      ->capture_default_str();
  app.add_option(
      "--keys", options.keys,
      "The folder of keys that tls:// needs: that of 'suture-manager', from suture keys");
  app.add_option("--user", options.users,
                 "unix: a user (by number) whose processes may come too; more than once for more");
  try {
    return run(app, options, argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "suture-manager: %s\n", suture::explained(error.what()).c_str());
    return kFailed;
  }
}
