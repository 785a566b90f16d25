#pragma once
// A deployment creates components by class name. suturec writes componentClass<T>() for each
// SUTURE_COMPONENT; a program lists the classes that it offers; no class registers itself.

#include <suture/annotate.h>
#include <suture/component/component.h>

#include <initializer_list>
#include <memory>
#include <string_view>

namespace suture {

class JsonReader;

/// A ComponentClass is a plain value: any thread may copy it. create() belongs to the thread that
/// sets up the process.
struct ComponentClass {
  const char* name;  ///< unqualified C++ name: "Psm"
  /// Reads the parameters and constructs the component. Returns null if the reader has reported a
  /// problem; what the constructor throws passes through.
  std::unique_ptr<Component> (*create)(const JsonReader& parameters);
};

/// For generated code: makes these required interfaces of `component` optional.
void makeOptional(Component& component, std::initializer_list<std::string_view> required);

/// For generated code: makes values that the required interface `required` of `component` reads
/// stale when they are older than that, unless a connection says otherwise.
void limitAge(Component& component, std::string_view required, Duration maxAge);

/// Returns the class `T`. Each component's generated header "X.suture.h" declares its own.
template <class T>
ComponentClass componentClass() {
  return Generated<T>::template result<ComponentClass>();
}

}  // namespace suture
