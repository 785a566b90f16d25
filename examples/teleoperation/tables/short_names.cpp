#include "tables/short_names.h"

#include <set>

namespace demo {

ShortNames::ShortNames(const std::vector<const suture::Deployment*>& deployments) {
  for (const suture::Deployment* const deployment : deployments) {
    std::set<std::string> seen;
    for (const suture::ProcessEntry& process : deployment->processes()) {
      for (const suture::ComponentEntry& component : process.components) {
        unique_ = seen.insert(component.name).second && unique_;
      }
    }
  }
}

std::string ShortNames::of(const std::string& process, const std::string& component) const {
  return unique_ ? component : process + ":" + component;
}

std::string ShortNames::of(const suture::Endpoint& endpoint) const {
  return of(endpoint.process, endpoint.component) + "/" + endpoint.interface;
}

std::string ShortNames::of(const suture::ConnectionEntry& connection) const {
  return of(connection.from) + " -> " + of(connection.to.process, connection.to.component);
}

}  // namespace demo
