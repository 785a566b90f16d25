#pragma once
// This is the client of the paper's loops.

#include <suture/component/task/task.h>

#include <cstdint>
#include <future>
#include <memory>
#include <vector>

#include "bench/table2/setup.h"

namespace bench {

/// A Client is a task of the kind that the setup asks for, which requires the interface "Server"
/// and goes round its loop as often as the setup says.
class Client {
 public:
  virtual ~Client() = default;
  virtual suture::Task& task() = 0;
  /// Returns what is ready when all samples are there.
  virtual std::future<void> finished() = 0;

  // The rest once the task has been stopped.

  /// Returns ns. With CSC they are from the write to the event. With SCS, event-driven, they are
  /// from fresh() to the end of the blocking write, twice across. With SCS, periodic, there are
  /// none, since only the server measures.
  virtual const std::vector<std::int64_t>& elapsed() const = 0;
  /// Returns how many calls were refused or had no answer within a second.
  virtual std::size_t failures() const = 0;
};

std::unique_ptr<Client> makeClient(const LoopSetup& setup);

}  // namespace bench
