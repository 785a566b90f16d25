#include <suture/base/errors.h>
#include <suture/base/nearest.h>
#include <suture/wiring/directory.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace suture {
namespace {

template <class Interface>
Interface* named(const std::vector<Interface*>& interfaces, const std::string& name) {
  const auto found = std::find_if(interfaces.begin(), interfaces.end(),
                                  [&](const Interface* one) { return one->name() == name; });
  return found == interfaces.end() ? nullptr : *found;
}

constexpr const char* kNameRule = "Choose a name without ':', '/', '->' and control characters";

/// Returns true if an endpoint and the name of a connection ("A/b -> C/d") can have `name` as a
/// part.
bool canBePart(const std::string& name) {
  const bool split =
      name.find_first_of(":/") != std::string::npos || name.find("->") != std::string::npos;
  return !name.empty() && !split && std::none_of(name.begin(), name.end(), [](unsigned char one) {
    return std::iscntrl(one) != 0;
  });
}

/// Throws SetupError unless each of `interfaces`, which are of this `kind`, has a name of its own.
template <class Interface>
void requireNames(const std::vector<Interface*>& interfaces, const std::string& kind,
                  const std::string& asked) {
  std::set<std::string> names;
  for (const Interface* one : interfaces) {
    if (!canBePart(one->name())) {
      throw SetupError(asked,
                       "no endpoint 'process:component/interface' could name its interface '" +
                           one->name() + "'",
                       kNameRule);
    }
    if (names.insert(one->name()).second) continue;
    throw SetupError(asked, "two of its " + kind + " interfaces are called '" + one->name() + "'",
                     "Give each of them its own name");
  }
}

/// Looks in `interfaces`, which are of this `kind`. `others` are those of the component that stand
/// at the other end of connections.
template <class Interface, class Other>
Interface& findIn(const std::vector<Interface*>& interfaces, const std::vector<Other*>& others,
                  const Endpoint& endpoint, const std::string& kind) {
  if (Interface* const found = named(interfaces, endpoint.interface)) return *found;
  std::vector<std::string> names;
  for (const Interface* one : interfaces) names.push_back(one->name());
  throw SetupError(
      "asked for the " + kind + " interface '" + endpoint.toString() + "'",
      "component '" + endpoint.component + "' has " + listNamed(kind + " interfaces", names),
      named(others, endpoint.interface)
          ? "It stands at the wrong end: a connection goes from a required interface "
            "to a provided one"
          : remedyForName(endpoint.interface, names));
}

}  // namespace

void Directory::add(const std::string& name, Component& component,
                    const std::function<void()>& prepare) {
  const std::lock_guard lock(mutex_);
  const std::string asked = "adding a component '" + name + "' to process '" + process_ + "'";
  if (!canBePart(name)) {
    throw SetupError(asked, "no endpoint 'process:component/interface' could name it", kNameRule);
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
  requireNames(component.provided(), "provided", asked);
  requireNames(component.required(), "required", asked);
  prepare();
  components_.emplace(name, &component);
}

std::vector<Component*> Directory::components() const {
  std::vector<Component*> all;
  for (const auto& [name, component] : componentsByName()) all.push_back(component);
  return all;
}

std::map<std::string, Component*> Directory::componentsByName() const {
  const std::lock_guard lock(mutex_);
  return components_;
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
                   "process '" + process_ + "' has " + listNamed("components", names),
                   remedyForName(component, names));
}

ProvidedBase& providedBy(const Component& component, const Endpoint& endpoint) {
  return findIn(component.provided(), component.required(), endpoint, "provided");
}

RequiredBase& requiredBy(const Component& component, const Endpoint& endpoint) {
  return findIn(component.required(), component.provided(), endpoint, "required");
}

ProvidedBase& Directory::provided(const Endpoint& endpoint) const {
  return providedBy(find(endpoint.component, endpoint.toString()), endpoint);
}

RequiredBase& Directory::required(const Endpoint& endpoint) const {
  return requiredBy(find(endpoint.component, endpoint.toString()), endpoint);
}

}  // namespace suture
