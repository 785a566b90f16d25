#include "harness/control_block.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "harness/clock.h"
#include "harness/fail.h"
#include "harness/futex.h"

namespace peers {
namespace {

constexpr std::chrono::seconds kPatience{15};

}  // namespace

ControlBlock& ControlBlock::open(const std::string& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT, 0600);
  if (descriptor < 0 || ftruncate(descriptor, sizeof(ControlBlock)) != 0) {
    fail("no control block in " + file);
  }
  void* const memory =
      mmap(nullptr, sizeof(ControlBlock), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  close(descriptor);
  if (memory == MAP_FAILED) fail("no memory for the control block");
  return *static_cast<ControlBlock*>(memory);
}

void ControlBlock::awaitReady(int servers) {
  for (int server = 0; server < servers; ++server) {
    if (!eventually([&] { return ready[server].load() != 0; }, kPatience)) {
      tellToStop();
      fail("server " + std::to_string(server) + " was not ready within 15 s");
    }
  }
}

void ControlBlock::tellToStop() {
  stop.store(1);
  futexWake(stop);
}

void ControlBlock::awaitStop() {
  while (stop.load() == 0) futexWait(stop, 0);
}

void ControlBlock::exitWhenTold() {
  awaitStop();
  std::_Exit(0);
}

void ControlBlock::exitWhenToldBeside() {
  std::thread([this] { exitWhenTold(); }).detach();
}

}  // namespace peers
