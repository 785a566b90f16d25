#pragma once
// This client goes round and round with a pose.

#include <suture/component/task/event_task.h>

#include <cstdint>
#include <future>
#include <vector>

#include "bench/sample_loop.suture.h"

namespace bench {

/// Sends a pose and, when it is back, the next one, from its first cycle on.
class SampleClient final : public suture::EventTask {
 public:
  using Samples = std::vector<std::int64_t>;

  SampleClient(int cpu, std::size_t skipped, std::size_t samples);
  ~SampleClient() override { stop(); }

  void run() override;
  /// Returns, once, what will have the ns of each round but the first `skipped`.
  std::future<Samples> samples() { return finished_.get_future(); }

  suture::Required<SampleServer> server{*this, "Server"};

 private:
  void send();
  void arrived(const robots::PoseSample& value);

  robots::PoseSample pose_;
  bool begun_ = false;
  const std::size_t skipped_;
  Samples elapsed_;
  std::promise<Samples> finished_;
};

}  // namespace bench
