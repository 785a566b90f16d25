#pragma once
#include <suture/annotate.h>
namespace demo {
class SUTURE_INTERFACE(version(2)) History {
 public:
  SUTURE_COMMAND(since(3)) virtual void later() = 0;
  SUTURE_EVENT(since(0)) suture::EventOf<> never;
};
class SUTURE_INTERFACE(version(0)) Zeroth {};
class SUTURE_INTERFACE() Misfits {
 public:
  SUTURE_COMMAND(deadline(0ms)) virtual int now(int x) = 0;
  SUTURE_COMMAND(deadline(5ms)) virtual int read() const = 0;
  SUTURE_COMMAND(concurrent()) virtual int count() const = 0;
  SUTURE_COMMAND(direct()) virtual int ask(int x) const = 0;
  SUTURE_COMMAND(latest()) virtual int next() = 0;
  SUTURE_COMMAND() virtual void on() = 0;
  SUTURE_EVENT() suture::EventOf<> provided;
};
}  // namespace demo
