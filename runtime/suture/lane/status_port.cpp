#include <suture/lane/status_port.h>

namespace suture {

StatusPort::StatusPort(loop::ControlThread& control, std::shared_ptr<Channel> channel)
    : ProviderEnd(std::move(channel)), control_(control) {
  control_.add(*this);
}

}  // namespace suture
