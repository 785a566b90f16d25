#pragma once
// This is a connection to another process that has been asked for, and is to be made.

#include <suture/component/required.h>
#include <suture/session/connect_options.h>
#include <suture/wiring/endpoint.h>

#include <memory>

namespace suture {

class DelayThread;

/// Says what is connected to what, and how, each time that the connection is made.
struct PlannedConnection {
  RequiredBase& required;
  Endpoint from, to;  ///< an empty process means this one
  ConnectOptions options;
  DelayThread* delays;                     ///< adds the delay of the options; null: they have none
  std::shared_ptr<ConnectionWatch> watch;  ///< outlives each channel
};

}  // namespace suture
