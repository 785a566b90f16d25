// A client that writes down what it sends, how that ends, and what it hears: history_client
// <manager address> <process name> <log> <its number> <robot> busy|idle <longest silence, ms>
// <lane>. Says "begun", then "ready" when it is connected to <robot>:PSM/Arm. An idle one only
// listens. Ends on SIGTERM.

#include <suture/base/errors.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <thread>

#include "fault/history_caller.h"

namespace {

using namespace std::chrono_literals;
using suture::now;

volatile std::sig_atomic_t ended = 0;

void say(const char* what) {
  std::puts(what);
  std::fflush(stdout);
}

/// As often as it is refused; false if it is to end.
bool connect(suture::Manager& manager, const std::string& arm, suture::Lane lane,
             suture::Duration silence) {
  while (ended == 0) {
    try {
      manager.connect("Client/Arm", arm, lane, 60s, {}, {.silence = silence});
      return true;
    } catch (const suture::SetupError&) {
      std::this_thread::sleep_for(5ms);
    }
  }
  return false;
}

}  // namespace

int main(int, char** argv) {
  std::signal(SIGTERM, [](int) { ended = 1; });
  const bool busy = std::string_view(argv[6]) == "busy";
  try {
    suture::HistoryCaller client(argv[3], static_cast<std::uint32_t>(std::atoi(argv[4])));
    suture::Manager manager(argv[2], argv[1], 60s);
    manager.add("Client", client);
    manager.start();
    say("begun");
    const auto silence = std::chrono::milliseconds(std::atoi(argv[7]));
    if (connect(manager, std::string(argv[5]) + ":PSM/Arm", suture::laneNamed(argv[8]), silence)) {
      say("ready");
    }
    while (ended == 0) {
      client.waitForEvents(now() + 5ms);
      client.processEvents();
      if (busy) client.ask();
    }
    manager.stop();
  } catch (const suture::SetupError& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
  return 0;
}
