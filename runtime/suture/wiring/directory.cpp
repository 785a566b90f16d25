#include <suture/base/errors.h>
#include <suture/base/nearest.h>
#include <suture/wiring/directory.h>

#include <algorithm>

namespace suture {
namespace {

template <class Interface>
Interface& findIn(const std::vector<Interface*>& interfaces, const Endpoint& endpoint,
                  const char* kind) {
  const auto found = std::find_if(interfaces.begin(), interfaces.end(), [&](const Interface* one) {
    return one->name() == endpoint.interface;
  });
  if (found != interfaces.end()) return **found;
  std::vector<std::string> names;
  for (const Interface* one : interfaces) names.push_back(one->name());
  throw SetupError(
      "asked for the " + std::string(kind) + " interface '" + endpoint.toString() + "'",
      "component '" + endpoint.component + "' has " + kind + " interfaces " + listNames(names),
      remedyForName(endpoint.interface, names));
}

}  // namespace

void Directory::add(const std::string& name, Component& component,
                    const std::function<void()>& prepare) {
  const std::lock_guard lock(mutex_);
  const std::string asked = "adding a component '" + name + "' to process '" + process_ + "'";
  if (name.empty() || name.find_first_of(":/") != std::string::npos) {
    throw SetupError(asked, "no endpoint 'process:component/interface' could name it",
                     "Choose a name without ':' and '/'");
  }
  if (components_.contains(name)) {
    throw SetupError(asked, "it has one of that name",
                     "Give each component of a process its own name");
  }
  for (const auto& [other, one] : components_) {
    if (one != &component) continue;
    throw SetupError(asked, "the same object is there as '" + other + "'",
                     "Add each component once");
  }
  prepare();
  components_.emplace(name, &component);
}

std::vector<Component*> Directory::components() const {
  const std::lock_guard lock(mutex_);
  std::vector<Component*> all;
  for (const auto& [name, component] : components_) all.push_back(component);
  return all;
}

const Component* Directory::findComponent(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  const auto found = components_.find(name);
  return found == components_.end() ? nullptr : found->second;
}

Component& Directory::find(const std::string& component, const std::string& asked) const {
  const std::lock_guard lock(mutex_);
  const auto found = components_.find(component);
  if (found != components_.end()) return *found->second;
  std::vector<std::string> names;
  for (const auto& [name, unused] : components_) names.push_back(name);
  throw SetupError("asked for '" + asked + "'",
                   "process '" + process_ + "' has components " + listNames(names),
                   remedyForName(component, names));
}

ProvidedBase& Directory::provided(const Endpoint& endpoint) const {
  Component& component = find(endpoint.component, endpoint.toString());
  return findIn(component.provided(), endpoint, "provided");
}

RequiredBase& Directory::required(const Endpoint& endpoint) const {
  Component& component = find(endpoint.component, endpoint.toString());
  return findIn(component.required(), endpoint, "required");
}

}  // namespace suture
