#include <suture/component/required.h>
#include <suture/deploy/document/connection_ends.h>
#include <suture/manager/lifecycle_interface.h>
#include <suture/wiring/directory.h>

#include <algorithm>
#include <string>
#include <vector>

namespace suture {
namespace {

bool requiresInterface(const Component& component, const std::string& name) {
  const auto& all = component.required();
  return std::any_of(all.begin(), all.end(),
                     [&](const RequiredBase* required) { return required->name() == name; });
}

/// Is what a file says wrong, and where.
struct Unconnected {
  std::string pointer;
  std::string remedy;
};

/// Says why a required interface has no connection: it is at the wrong end of one, a connection of
/// its component names an interface that there is not, or nothing mentions it.
Unconnected unconnected(const Endpoint& from, const ComponentEntry& entry,
                        const Component& component, std::span<const ConnectionEntry> all) {
  const auto first = [&](const auto& condition) {
    return std::find_if(all.begin(), all.end(), condition);
  };
  const auto swapped =
      first([&](const ConnectionEntry& one) { return one.to.toString() == from.toString(); });
  if (swapped != all.end()) {
    return {swapped->pointer, "it is named as \"to\": exchange \"from\" and \"to\""};
  }
  const auto misspelt = first([&](const ConnectionEntry& one) {
    return one.from.process == from.process && one.from.component == from.component &&
           !requiresInterface(component, one.from.interface);
  });
  if (misspelt != all.end()) {
    return {misspelt->pointer, "write it as \"from\" in the place of '" +
                                   misspelt->from.toString() + "', which there is not"};
  }
  return {entry.pointer, "add a connection {\"from\": \"" + from.toString() + "\", \"to\": ...}"};
}

/// Appends what is wrong with the required interfaces of one component.
void findUnconnected(const Deployment& deployment, const std::string& process,
                     const ComponentEntry& entry, const Component& component,
                     std::vector<std::string>& problems) {
  const auto& all = deployment.connections();
  for (const RequiredBase* required : component.required()) {
    const Endpoint from{process, entry.name, required->name()};
    const bool connected = std::any_of(all.begin(), all.end(), [&](const ConnectionEntry& one) {
      return one.from.toString() == from.toString();
    });
    if (connected || required->isOptional()) continue;
    const Unconnected found = unconnected(from, entry, component, all);
    problems.push_back(deployment.document().locate(
        found.pointer, "required interface '" + from.toString() + "' (" + required->info().name +
                           ") has no provider; " + found.remedy));
  }
}

/// Appends which ends of connections name an interface that one component does not have.
void findUnknown(const Deployment& deployment, const std::string& process,
                 const ComponentEntry& entry, const Component& component,
                 std::vector<std::string>& problems) {
  const auto isHere = [&](const Endpoint& end) {
    // The manager gives each component this interface later.
    return end.process == process && end.component == entry.name &&
           end.interface != LifecycleInterface::kName;
  };
  for (const ConnectionEntry& connection : deployment.connections()) {
    try {
      if (isHere(connection.from)) requiredBy(component, connection.from);
      if (isHere(connection.to)) providedBy(component, connection.to);
    } catch (const SetupError& error) {
      problems.push_back(deployment.document().locate(connection.pointer, error.what()));
    }
  }
}

}  // namespace

// A required interface whose connection misspells it is told once, with its remedy.
void checkConnections(const Deployment& deployment, const ProcessEntry& process,
                      std::span<const std::unique_ptr<Component>> components) {
  std::vector<std::string> problems;
  for (const auto find : {findUnconnected, findUnknown}) {
    for (std::size_t i = 0; i < components.size(); ++i) {
      find(deployment, process.name, process.components[i], *components[i], problems);
    }
    if (!problems.empty()) throw DocumentError(problems);
  }
}

}  // namespace suture
