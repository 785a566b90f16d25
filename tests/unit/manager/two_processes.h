#pragma once

#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include "support/temporary_directory.h"

namespace suture {

/// Holds two managers that are two processes to each other. Declare before it what is added to
/// them.
struct TwoProcesses {
  void start() {
    there.start();
    here.start();
  }

  TemporaryDirectory directory;
  loop::ControlThread control;
  GlobalManager global{control, "unix:" + directory.file("manager.sock")};
  Manager there{"there", global.address()}, here{"here", global.address()};
};

}  // namespace suture
