#pragma once
// This is the server of the paper's loops.

#include <suture/component/task/task.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "bench/loop.suture.h"
#include "bench/table2/setup.h"

namespace bench {

/// A Server is a task of the kind that the setup asks for, which provides the interface "Loop".
class Server {
 public:
  virtual ~Server() = default;
  virtual suture::Task& task() = 0;
  /// Returns, once the task has been stopped, how long each value was away that came back by put(),
  /// ns.
  virtual const std::vector<std::int64_t>& elapsed() const = 0;
};

std::unique_ptr<Server> makeServer(const LoopSetup& setup);

}  // namespace bench
