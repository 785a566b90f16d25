#pragma once
#include <suture/annotate.h>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <variant>
namespace demo {
struct SUTURE_TYPE() Animal {
  virtual ~Animal() = default;
};
struct Free {
  void operator()(int* p) const;
};
struct SUTURE_TYPE() Containers {
  std::map<double, int> real;
  std::set<Animal> animals;
  std::map<int, int, std::greater<>> downwards;
  std::list<int> chain;
  std::variant<int> single;
  std::tuple<> nothing;
  std::variant<int, std::function<void()>> code;
  std::monostate alone;
  std::unique_ptr<Animal> pet;
  std::unique_ptr<int, Free> freed;
};
class SUTURE_INTERFACE() Contract {
 public:
  virtual ~Contract() = default;
  SUTURE_EVENT() suture::EventOf<int[3]> three;
};
}  // namespace demo
