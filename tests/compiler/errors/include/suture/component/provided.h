#pragma once
#include <string_view>

#include <suture/component/component.h>
namespace suture {
template <class Contract>
class Provided {
 public:
  Provided(Component&, std::string_view, Contract&);
};
}  // namespace suture
