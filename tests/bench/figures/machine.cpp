#include "bench/figures/machine.h"

#include <sys/utsname.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

namespace bench {
namespace {

std::string processorName() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

}  // namespace

nlohmann::json describeMachine() {
  utsname kernel{};
  uname(&kernel);
  double load = 0;
  getloadavg(&load, 1);
  return {{"processor", processorName()},
          {"processors", std::thread::hardware_concurrency()},
          {"kernel", kernel.release},
          {"load", load},
          {"compiler", __VERSION__},
          {"optimised",
#ifdef NDEBUG
           true
#else
           false
#endif
          }};
}

}  // namespace bench
