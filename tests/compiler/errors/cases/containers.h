#pragma once
#include <suture/annotate.h>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>
#include <variant>
namespace demo {
struct SUTURE_TYPE() Animal {
  virtual ~Animal() = default;
};
struct Free {
  void operator()(int* p) const;
};
struct Shouting : std::char_traits<char> {};
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
  std::unordered_map<std::string, int, std::hash<std::string>, std::equal_to<>> alike;
  std::set<int, std::less<short>> widened;
  std::unique_ptr<int, std::default_delete<const int>> another;
  std::basic_string<char, Shouting> loud;
  // These order as the default does.
  std::map<std::string, int, std::less<>> names;
  std::set<std::string, std::less<>> words;
};
class SUTURE_INTERFACE() Contract {
 public:
  virtual ~Contract() = default;
  SUTURE_EVENT() suture::EventOf<int[3]> three;
};
}  // namespace demo
