#pragma once
// This client has no cycles: it calls in the thread of the measurement, when that has it call.

#include <suture/component/device.h>

#include "bench/sample_loop.suture.h"

namespace bench {

struct SampleDevice final : suture::Device {
  suture::Required<SampleServer> server{*this, "Server"};
};

}  // namespace bench
