#pragma once
// A shared library offers its components to deployments with this. suturec writes its one entry
// point for a target that is LOADABLE:
//   extern "C" const suture::ComponentLibrary* suture_components();

#include <suture/base/time.h>
#include <suture/component/factory/component_class.h>

#include <atomic>
#include <span>

namespace suture {

/// Names this release of Suture. A library that was built with another one is refused.
inline constexpr const char kVersion[] = "0.1.0";

/// Names the entry point.
inline constexpr const char kComponentsEntry[] = "suture_components";

struct ComponentLibrary {
  const char* version;  ///< the version of Suture that built it; first, so that any can read it
  std::span<const ComponentClass> classes;
  /// The runtime inside the library asks this for time. The program that loads the library stores
  /// its own stepped clock there.
  std::atomic<VirtualTime*>* virtualTime = &detail::virtualTime;
};

using ComponentsEntry = const ComponentLibrary* (*)();

}  // namespace suture
