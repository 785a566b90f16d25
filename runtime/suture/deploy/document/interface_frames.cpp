#include <suture/base/nearest.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/deploy/document/interface_frames.h>

namespace suture {
namespace {

/// Declares the frames, or returns false and fills `names` if none of `interfaces` has that name.
template <class Interface>
bool declare(const std::vector<Interface*>& interfaces, const std::string& name,
             const Frames& frames, std::vector<std::string>& names) {
  bool found = false;
  for (Interface* const one : interfaces) {
    names.push_back(one->name());
    if (one->name() != name) continue;
    one->declareFrames(frames);
    found = true;
  }
  return found;
}

/// Throws SetupError.
void declare(const Component& component, const std::string& name, const Frames& frames) {
  std::vector<std::string> names;
  const bool provided = declare(component.provided(), name, frames, names);
  const bool required = declare(component.required(), name, frames, names);
  if (provided || required) return;
  throw SetupError("declaring the frames of interface '" + name + "'",
                   "its component has " + listNamed("interfaces", names),
                   remedyForName(name, names));
}

}  // namespace

void declareFrames(const JsonDocument& document, const ProcessEntry& process,
                   std::span<const std::unique_ptr<Component>> components,
                   std::vector<std::string>& problems) {
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (components[i] == nullptr) continue;
    const ComponentEntry& entry = process.components[i];
    for (const auto& [name, frames] : entry.frames) {
      try {
        declare(*components[i], name, frames);
      } catch (const SetupError& error) {
        problems.push_back(document.locate(entry.pointer + "/frames/" + name,
                                           "component '" + entry.name + "': " + error.what()));
      }
    }
  }
}

}  // namespace suture
