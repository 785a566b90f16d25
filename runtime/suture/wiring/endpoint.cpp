#include <suture/base/errors.h>
#include <suture/component/channel/channel.h>
#include <suture/wiring/endpoint.h>

namespace suture {

Endpoint Endpoint::parse(std::string_view text) {
  const std::size_t slash = text.rfind('/');
  const std::size_t colon = text.find(':');
  Endpoint endpoint;
  if (slash != std::string_view::npos && (colon == std::string_view::npos || colon < slash)) {
    const std::size_t begin = colon == std::string_view::npos ? 0 : colon + 1;
    endpoint.process = std::string(text.substr(0, begin == 0 ? 0 : colon));
    endpoint.component = std::string(text.substr(begin, slash - begin));
    endpoint.interface = std::string(text.substr(slash + 1));
  }
  if (endpoint.component.empty() || endpoint.interface.empty() || colon == 0) {
    throw SetupError("an interface was named '" + std::string(text) + "'",
                     "that is not of the form component/interface or process:component/interface",
                     "Write for example \"PSM1/Arm\", or \"left:PSM1/Arm\" for another process");
  }
  return endpoint;
}

std::string Endpoint::toString() const {
  return (process.empty() ? "" : process + ":") + component + "/" + interface;
}

std::string connectionName(const Endpoint& from, const Endpoint& to) {
  return from.toString().append(Channel::kArrow) + to.toString();
}

}  // namespace suture
