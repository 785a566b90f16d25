#pragma once
// This reports and counts what a process refuses at its address.

#include <suture/base/time.h>

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace suture::net {

/// Reports each refusal on standard error, for the person who runs the process that refuses; the
/// peer is told by its answer. The process's reports have the count.
class Refusals {
 public:
  /// `owner` is the process that refuses; each line begins with it.
  explicit Refusals(std::string owner) : owner_(std::move(owner)) {}

  /// The control thread. Adds a refusal. The same line is printed once a minute, and at most 20
  /// lines a minute, so that a peer that comes again and again fills no log; none is while nobody
  /// reads standard error. `peer` says who it is, as far as is known.
  void add(const std::string& peer, const std::string& text);

  struct Summary {
    std::uint64_t count = 0;
    std::string latest;  ///< "user 1000: use 'left:PSM/Arm': ..."; "" if there was none
  };
  /// Any thread.
  Summary summary() const;

 private:
  bool mayPrint(const std::string& line);

  const std::string owner_;
  std::map<std::string, Time> printed_;  // in the last minute
  mutable std::mutex mutex_;             // never taken by a task thread
  Summary summary_;
};

}  // namespace suture::net
