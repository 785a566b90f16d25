#include <suture/base/nearest.h>
#include <suture/component/required.h>
#include <suture/deploy/document/connection_ends.h>
#include <suture/manager/lifecycle_interface.h>
#include <suture/wiring/directory.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace suture {
namespace {

/// Returns the required interface of `component` whose name is spelled most like `name`; "": none.
std::string nearestRequired(const Component& component, const std::string& name) {
  std::vector<std::string> names;
  for (const RequiredBase* required : component.required()) names.push_back(required->name());
  return nearestName(name, names);
}

/// Returns true if a connection names `from` in the wrong way, of which findUnknown() tells.
bool isMisspelt(const Endpoint& from, const Component& component,
                std::span<const ConnectionEntry> all) {
  return std::any_of(all.begin(), all.end(), [&](const ConnectionEntry& one) {
    return one.from.process == from.process && one.from.component == from.component &&
           nearestRequired(component, one.from.interface) == from.interface;
  });
}

/// An Unconnected is what a file says wrong, and where.
struct Unconnected {
  std::string pointer;
  std::string remedy;
};

/// Says why a required interface has no connection: it is at the wrong end of one, or nothing
/// mentions it.
Unconnected unconnected(const Endpoint& from, const ComponentEntry& entry,
                        std::span<const ConnectionEntry> all) {
  const auto swapped = std::find_if(all.begin(), all.end(), [&](const ConnectionEntry& one) {
    return one.to.toString() == from.toString();
  });
  if (swapped != all.end()) {
    return {swapped->pointer, "it is named as \"to\": exchange \"from\" and \"to\""};
  }
  return {entry.pointer, "add a connection {\"from\": \"" + from.toString() + "\", \"to\": ...}"};
}

/// Judges the ends of connections that lie in one process.
class Ends {
 public:
  Ends(const Deployment& deployment, const std::string& process, std::set<std::string> told,
       std::vector<std::string>& problems)
      : deployment_(deployment), process_(process), problems_(problems), told_(std::move(told)) {}

  /// Adds what is wrong with the required interfaces of one component.
  void findUnconnected(const ComponentEntry& entry, const Component& component) {
    const auto& all = deployment_.connections();
    for (const RequiredBase* required : component.required()) {
      const Endpoint from{process_, entry.name, required->name()};
      const bool connected = std::any_of(all.begin(), all.end(), [&](const ConnectionEntry& one) {
        return one.from.toString() == from.toString();
      });
      if (connected || required->isOptional() || isMisspelt(from, component, all)) continue;
      const Unconnected found = unconnected(from, entry, all);
      told_.insert(found.pointer);
      problems_.push_back(deployment_.document().locate(
          found.pointer, "required interface '" + from.toString() + "' (" + required->info().name +
                             ") has no provider; " + found.remedy));
    }
  }

  /// Adds which ends of connections name an interface that one component does not have, but for
  /// connections of which something has been told.
  void findUnknown(const ComponentEntry& entry, const Component& component) {
    const auto isHere = [&](const Endpoint& end) {
      // The manager gives each component this interface later.
      return end.process == process_ && end.component == entry.name &&
             end.interface != LifecycleInterface::kName;
    };
    for (const ConnectionEntry& connection : deployment_.connections()) {
      if (told_.contains(connection.pointer)) continue;
      try {
        if (isHere(connection.from)) requiredBy(component, connection.from);
        if (isHere(connection.to)) providedBy(component, connection.to);
      } catch (const SetupError& error) {
        problems_.push_back(deployment_.document().locate(connection.pointer, error.what()));
      }
    }
  }

 private:
  const Deployment& deployment_;
  const std::string& process_;
  std::vector<std::string>& problems_;
  std::set<std::string> told_;  // the places of connections
};

}  // namespace

// A required interface whose connection misspells it is told once, with its remedy.
void checkConnections(const Deployment& deployment, const ProcessEntry& process,
                      std::span<const std::unique_ptr<Component>> components,
                      std::set<std::string> told, std::vector<std::string>& problems) {
  Ends ends(deployment, process.name, std::move(told), problems);
  for (const auto find : {&Ends::findUnconnected, &Ends::findUnknown}) {
    for (std::size_t i = 0; i < components.size(); ++i) {
      if (components[i] != nullptr) (ends.*find)(process.components[i], *components[i]);
    }
  }
}

}  // namespace suture
