// There are a gripper, a listener that is there from the start, and one that comes late. The
// gripper has a thread of its own; both listeners belong to this one.

#include <suture/base/errors.h>
#include <suture/base/plain.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include "05_events/listener.h"
#include "05_events/simulated_gripper.h"

namespace {

using gripping::Jaws;
using gripping::Listener;

void grasp(Listener& early) {
  // The wait begins here, before the command is sent, so that no touch is missed in between.
  auto touch = early.gripper().on().touched.next();
  if (const auto sent = early.gripper().grasp(); !sent) {
    throw std::runtime_error(std::string("grasp: ") + toString(sent.error()));
  }
  const auto force = touch.within(std::chrono::seconds(2));
  if (!force) throw std::runtime_error(std::string("no touch: ") + toString(force.error()));
  std::printf("the first touch has come, %.1f N\n", *force);
  while (early.jaws() != Jaws::Holding) early.listen();
}

void release(Listener& late) {
  bool answered = false;
  late.gripper().release.start().then([&answered](const suture::Result<bool>& held) {
    std::printf("the answer is: %s\n",
                held ? *held ? "it held something" : "it held nothing" : toString(held.error()));
    answered = true;
  });
  while (!answered || late.jaws() != Jaws::Open) late.listen();
}

void run() {
  gripping::SimulatedGripper gripper;
  suture::Manager manager("cell");
  manager.add("Gripper", gripper);
  manager.start();

  Listener early(manager, "early");
  grasp(early);

  Listener late(manager, "late");  // receives the state, and none of the touches that are over
  while (!late.jaws()) late.listen();
  release(late);
  while (early.jaws() != Jaws::Open) early.listen();
}

}  // namespace

int main() {
  try {
    run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", suture::explained(error.what()).c_str());
    return 1;
  }
}
