#pragma once
// This says how a connection is to be made.

#include <suture/component/contract/connection_contract.h>
#include <suture/lane/delay/connection_delay.h>
#include <suture/lane/lane.h>

#include <chrono>

namespace suture {

/// Holds what Manager::connect() gets beside the two interfaces.
///   manager.connect("Teleop/Slave", "psm-host:PSM/Arm", {.patience = 1min});
struct ConnectOptions {
  /// This is how long connect() waits for another process to appear, without a `patience`.
  static constexpr Duration kDefaultPatience = std::chrono::seconds(10);

  /// A lane other than Lane::Auto is used within the process as well. If it cannot be had, the next
  /// slower one is used, and reports say why.
  Lane lane = Lane::Auto;
  /// Makes the connection fail rather than travel by another lane. Lane::Auto cannot be required.
  bool laneRequired = false;
  Duration patience = kDefaultPatience;
  ConnectionDelay delay = {};  ///< added to what the lane takes, by another thread
  /// See docs/safety.md; without a max_age, that of the required interface holds.
  ConnectionContract contract = {};
};

}  // namespace suture
