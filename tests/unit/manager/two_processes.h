#pragma once

#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include "support/temporary_directory.h"

namespace suture {

/// Two managers that are two processes to each other. What is added to them is declared before.
struct TwoProcesses {
  void start() {
    there.start();
    here.start();
  }

  TemporaryDirectory directory;
  rpc::ControlThread control;
  GlobalManager global{control, "unix:" + directory.file("manager.sock")};
  Manager there{"there", global.address()}, here{"here", global.address()};
};

}  // namespace suture
