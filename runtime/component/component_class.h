#pragma once
// How a deployment creates components by class name. suturec writes componentClass<T>() for each
// SUTURE_COMPONENT; a program lists the classes it offers; nothing registers itself.

#include <suture/component/component.h>
#include <suture/component/json_reader.h>

#include <memory>
#include <vector>

namespace suture {

struct ComponentClass {
  const char* name;  ///< unqualified C++ name: "Psm"
  /// Reads the parameters and constructs the component; null if `parameters` reported a problem.
  std::unique_ptr<Component> (*create)(JsonReader parameters, const std::vector<JsonProblem>& problems);
};

/// The class `T`. Specialised in its generated header.
template <class T>
ComponentClass componentClass() = delete;

}  // namespace suture
