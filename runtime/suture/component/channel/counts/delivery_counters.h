#pragma once
// This counts what a lane has done to the messages of a connection.

#include <atomic>
#include <cstdint>

namespace suture {

/// The receiving ends count these. Such a message has no effect other than its count.
struct DeliveryCounters {
  std::atomic<std::uint64_t> lost{0};        ///< never taken: they did not come in time
  std::atomic<std::uint64_t> duplicated{0};  ///< had come before; dropped
  std::atomic<std::uint64_t> overtaken{0};   ///< came after a newer one; dropped, also among `lost`
};

}  // namespace suture
