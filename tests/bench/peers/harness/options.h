#pragma once

#include <string>

namespace peers {

/// A process of a measurement is started so: PROGRAM VARIANT ROLE MEASUREMENT [--NAME VALUE]...
struct Options {
  std::string variant;      ///< which way of the peer is measured
  std::string role;         ///< "server" or "client"
  std::string measurement;  ///< one of measurements.h
  std::string control;      ///< the file of the control block
  std::string place;        ///< the beginning of paths that belong to this run alone
  int port = 0;             ///< the first of 400 that belong to this run
  int cpu = -1;             ///< all threads run on it; -1: on any
  int server = 0;           ///< this process's number among the servers
  int servers = 1;          ///< how many there are
  long count = 1000;        ///< how many messages are sent
  double seconds = 1;       ///< that a loop may take

  /// Names a Unix socket of that server.
  std::string socketPath(int ofServer) const {
    return place + "." + std::to_string(ofServer) + ".sock";
  }
  bool fansOut() const { return measurement == "fan_out"; }
};

/// Ends the process if it does not understand an argument.
Options parsedOptions(int count, char** arguments);

}  // namespace peers
