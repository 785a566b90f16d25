#pragma once
#include <suture/annotate.h>
#include <map>
#include <thread>
#include <vector>
namespace lib {
struct Point {
  double x, y;
  double norm() const;
};
struct Line {
  Point from, to;
  std::thread worker;
};
template <class T>
struct Box {
  T value;
};
struct Later;
enum Mode { Slow, Fast };
class Secret {
  int x_ = 0;
};
struct View {
  double x = 0;
  const double& again = x;
  void* raw = nullptr;
};
struct Codes {
  std::map<char, int> names;
  std::vector<char> bytes;
};
struct Boxes {
  Box<float> first;
  std::vector<Box<int>> others;
};
}  // namespace lib
namespace demo {
struct SUTURE_TYPE() Ours {
  int x = 0;
};
SUTURE_EXTERNAL_TYPE(lib::Point, x, member(y, unit("parsec")), norm);
SUTURE_EXTERNAL_TYPE(lib::Line, from, worker, member(to, queue(3)));
SUTURE_EXTERNAL_TYPE(lib::Point, x);
SUTURE_EXTERNAL_TYPE(lib::Box<int>, value);
SUTURE_EXTERNAL_TYPE(lib::Later);
SUTURE_EXTERNAL_TYPE(Ours, x);
SUTURE_EXTERNAL_TYPE(int);
SUTURE_EXTERNAL_TYPE(lib::Mode, name("Pace"));
SUTURE_EXTERNAL_TYPE(lib::Secret);
SUTURE_EXTERNAL_TYPE(lib::View, all(), member(x, unit("parsec")));
SUTURE_EXTERNAL_TYPE(lib::Codes);
SUTURE_EXTERNAL_TYPE(lib::Boxes);
}  // namespace demo
