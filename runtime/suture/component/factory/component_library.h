#pragma once
// What a shared library of components offers to deployments. suturec writes its one entry point for
// a target that is LOADABLE:
//   extern "C" const suture::ComponentLibrary* suture_components();

#include <suture/base/time.h>
#include <suture/component/factory/component_class.h>

#include <atomic>
#include <span>

namespace suture {

/// This release of Suture. What has been built with another one does not fit.
inline constexpr const char kVersion[] = "0.1.0";

/// The name of the entry point.
inline constexpr const char kComponentsEntry[] = "suture_components";

struct ComponentLibrary {
  const char* version;  ///< of the Suture it was built with; first, so that any other can read it
  std::span<const ComponentClass> classes;
  /// The runtime inside the library asks it for time. The program that loads the library stores its
  /// own stepped clock there.
  std::atomic<VirtualTime*>* virtualTime = &detail::virtualTime;
};

using ComponentsEntry = const ComponentLibrary* (*)();

}  // namespace suture
