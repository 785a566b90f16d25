#pragma once
// The server of the paper's loops.

#include <suture/component/task/task.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "bench/loop.suture.h"
#include "bench/table2/setup.h"

namespace bench {

/// A task of the kind that the setup asks for, which provides the interface "Loop".
class Server {
 public:
  virtual ~Server() = default;
  virtual suture::Task& task() = 0;
  /// How long each value was away that came back by put(), ns. Once the task has been stopped.
  virtual const std::vector<std::int64_t>& elapsed() const = 0;
};

std::unique_ptr<Server> makeServer(const LoopSetup& setup);

}  // namespace bench
