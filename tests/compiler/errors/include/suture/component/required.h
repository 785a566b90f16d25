#pragma once
#include <string_view>

#include <suture/component/component.h>
namespace suture {
template <class Contract>
class Required {
 public:
  Required(Component&, std::string_view);
};
}  // namespace suture
