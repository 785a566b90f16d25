#pragma once
// A client that calls only when the measurement has it call.

#include <suture/component/device.h>

#include "bench/sample_loop.suture.h"

namespace bench {

struct SampleDevice final : suture::Device {
  suture::Required<SampleServer> server{*this, "Server"};
};

}  // namespace bench
