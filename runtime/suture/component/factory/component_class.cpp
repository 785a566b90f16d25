#include <suture/base/errors.h>
#include <suture/component/factory/component_class.h>
#include <suture/component/required.h>

#include <string>

namespace suture {
namespace {

/// Finds a required interface by the name that it has in the header: a constructor may have given
/// it another.
RequiredBase& requiredOf(Component& component, std::string_view name) {
  for (RequiredBase* one : component.required()) {
    if (one->name() == name) return *one;
  }
  throw SetupError("its header declares a required interface '" + std::string(name) +
                   "' that is optional() or has a max_age(), and the component has none of that "
                   "name. Call it the same in the header and in the constructor");
}

}  // namespace

void makeOptional(Component& component, std::initializer_list<std::string_view> required) {
  for (const std::string_view one : required) requiredOf(component, one).makeOptional();
}

void limitAge(Component& component, std::string_view required, Duration maxAge) {
  requiredOf(component, required).limitAge(maxAge);
}

}  // namespace suture
