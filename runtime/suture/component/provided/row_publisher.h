#pragma once
// A provided interface publishes the values of its reads here, a row at a time.

#include <suture/component/provided/command_runner.h>
#include <suture/component/provided/interface_clients.h>
#include <suture/rt/state/row_columns.h>

#include <atomic>
#include <memory>
#include <mutex>

namespace suture::rt {
class StateTable;
}

namespace suture {

/// Says how a provided interface keeps the values of its reads.
struct StateOptions {
  /// says how many rows of the past can be read at least; a power of two
  unsigned rows = 64;
  static constexpr unsigned kMostRows = 1u << 20;
  /// lets only advance() publish rows, not the end of each cycle; not for a device
  bool manual = false;
};

/// Belongs to the thread that serves the interface, except where a comment says otherwise.
class RowPublisher {
 public:
  RowPublisher(InterfaceClients& clients, CommandRunner& runner)
      : clients_(clients), runner_(runner) {}
  RowPublisher(const RowPublisher&) = delete;
  RowPublisher& operator=(const RowPublisher&) = delete;

  /// In the component's constructor. Throws SetupError if the interface is in use already, or if
  /// `options` do not suit it.
  void keep(const StateOptions& options);
  bool areManual() const { return options_.manual; }
  /// Any thread. Returns what publish() fills. The first call allocates it, or throws SetupError if
  /// there is no memory.
  const std::shared_ptr<rt::StateTable>& table();
  /// Any thread. Returns the columns that clients have asked for.
  rt::ColumnSet demand() const;
  /// Evaluates the reads that clients have asked for, and publishes them as one row, stamped now.
  void publish();

 private:
  InterfaceClients& clients_;
  CommandRunner& runner_;
  StateOptions options_{.rows = 0};  // 0: as many rows as their size suggests
  std::once_flag made_;
  std::shared_ptr<rt::StateTable> table_;
  std::atomic<rt::StateTable*> usable_{nullptr};  // points to what table() has made
};

}  // namespace suture
