#pragma once
// This has the components of one process, by name.

#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/wiring/endpoint.h>

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace suture {

/// Return the component's interface that `endpoint` names. They throw a SetupError that lists what
/// the component has.
ProvidedBase& providedBy(const Component& component, const Endpoint& endpoint);
RequiredBase& requiredBy(const Component& component, const Endpoint& endpoint);

/// Any thread. Does not own the components; they outlive it. Look-ups throw a SetupError that lists
/// what exists.
class Directory {
 public:
  explicit Directory(std::string process) : process_(std::move(process)) {}

  const std::string& process() const { return process_; }

  /// `prepare` makes the component ready to be found by other threads. It is not called if the name
  /// or the component is refused, or one of its interfaces has no name of its own, and if it throws
  /// the component is not added. It must not use this directory.
  void add(const std::string& name, Component& component, const std::function<void()>& prepare);
  std::vector<Component*> components() const;
  std::map<std::string, Component*> componentsByName() const;

  Component& component(const std::string& name) const { return find(name, name); }
  /// Returns nullptr if there is none of that name.
  const Component* findComponent(const std::string& name) const;
  ProvidedBase& provided(const Endpoint& endpoint) const;
  RequiredBase& required(const Endpoint& endpoint) const;

 private:
  Component& find(const std::string& name, const std::string& asked) const;

  const std::string process_;
  mutable std::mutex mutex_;
  std::map<std::string, Component*> components_;
};

}  // namespace suture
