#include "bench/local/sample_client.h"

#include "bench/local/sample_server.h"

namespace bench {

using robots::PoseSample;
using suture::now;

SampleClient::SampleClient(int cpu, std::size_t skipped, std::size_t samples)
    : EventTask({.scheduling = {.processor = cpu}}), pose_(poseSample()), skipped_(skipped) {
  elapsed_.reserve(skipped + samples);
  server.on().echo([this](const PoseSample& value) { arrived(value); });
}

void SampleClient::run() {
  if (begun_ || !server.connected()) return;
  begun_ = true;
  send();
}

void SampleClient::send() {
  pose_.stamp = now();
  server.bounce(pose_);
}

void SampleClient::arrived(const PoseSample& value) {
  elapsed_.push_back((now() - value.stamp).count());
  if (elapsed_.size() < elapsed_.capacity()) return send();
  finished_.set_value(
      Samples(elapsed_.begin() + static_cast<std::ptrdiff_t>(skipped_), elapsed_.end()));
}

}  // namespace bench
