#include <suture/component/factory/component_class.h>
#include <suture/component/required.h>

#include <algorithm>

namespace suture {

void makeOptional(Component& component, std::initializer_list<std::string_view> required) {
  for (RequiredBase* one : component.required()) {
    if (std::find(required.begin(), required.end(), one->name()) != required.end()) {
      one->makeOptional();
    }
  }
}

void limitAge(Component& component, std::string_view required, Duration maxAge) {
  for (RequiredBase* one : component.required()) {
    if (one->name() == required) one->limitAge(maxAge);
  }
}

}  // namespace suture
