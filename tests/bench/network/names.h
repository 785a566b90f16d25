#pragma once
// The global manager between the processes of a measurement.

#include <suture/manager/global_manager.h>
#include <suture/transport/rpc/control_thread.h>

#include <string>

#include "bench/table2/setup.h"
#include "support/temporary_directory.h"

namespace bench {

/// Made before the processes that it serves, and gone after them.
class Names {
 public:
  /// Throws SetupError.
  explicit Names(Transport transport) : manager_(control_, wanted(transport)) {}

  const std::string& address() const { return manager_.address(); }

 private:
  std::string wanted(Transport transport) const {
    return transport == Transport::Tcp ? "tcp://127.0.0.1:0" : "unix:" + folder_.file("manager");
  }

  const suture::TemporaryDirectory folder_;
  suture::rpc::ControlThread control_;
  const suture::GlobalManager manager_;
};

}  // namespace bench
