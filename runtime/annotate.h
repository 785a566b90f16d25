#pragma once
// The annotation vocabulary: what an engineer writes in a header so that suturec can read it.
//
// Under every compiler but suturec the macros expand to nothing. Under suturec each becomes a
// [[clang::annotate]] whose arguments are constexpr calls into suture::dsl, so clang itself reports
// a misspelt or mistyped argument at its own column. This file is the only one that both sides of
// the project know.
//
//   struct SUTURE_TYPE() Pose { SUTURE_FIELD(unit("m")) double x = 0; };
//   class SUTURE_INTERFACE() Arm {
//    public:
//     SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_cp(const Pose& goal) = 0;
//     SUTURE_EVENT(latched()) suture::EventOf<Pose> arrived;
//   };

#include <chrono>

namespace suture {

/// Declares an event inside a contract. It is a tag without state: only Provided emits an event,
/// only Required subscribes to one. `EventOf<>` is a void event, `EventOf<T>` a write event.
template <class... Arguments>
struct EventOf {};

}  // namespace suture

#ifdef SUTUREC

using namespace std::chrono_literals;

namespace suture::dsl {

using Nanoseconds = std::chrono::nanoseconds;

struct Unit {
  const char* symbol;
};
struct Range {
  double lowest, highest;
};
struct Capacity {
  unsigned outer, inner, innermost;
};
struct Was {
  const char* name;
};
struct Name {
  const char* name;
};
struct Queue {
  unsigned depth;
};
struct Latest {
  bool set;
};
struct Ttl {
  long long nanoseconds;
};
struct Latched {
  bool set;
};
struct Skip {
  bool set;
};

/// Unit of a number, SI or derived: "m", "rad", "m/s", "N.m".
consteval Unit unit(const char* symbol) { return {symbol}; }
/// Inclusive range that the receiving end enforces.
consteval Range range(double lowest, double highest) { return {lowest, highest}; }
/// Upper bound of a string or a list, one number a level, outside in.
consteval Capacity capacity(unsigned outer, unsigned inner = 0, unsigned innermost = 0) {
  return {outer, inner, innermost};
}
/// The name this had before: keeps its place on the wire.
consteval Was was(const char* name) { return {name}; }
/// The name on the wire, where the C++ name will not do.
consteval Name name(const char* wireName) { return {wireName}; }
/// How many of this command or event may wait.
consteval Queue queue(unsigned depth) { return {depth}; }
/// Only the newest counts: a waiting older one is replaced.
consteval Latest latest() { return {true}; }
/// A command older than this when its turn comes is discarded and counted as late.
consteval Ttl ttl(Nanoseconds age) { return {age.count()}; }
/// A late subscriber receives the last value.
consteval Latched latched() { return {true}; }
/// Not on the wire: the receiver keeps its own.
consteval Skip skip() { return {true}; }

}  // namespace suture::dsl

// Qualifies each argument with ::suture::dsl:: (up to eight of them).
#define SUTURE_DSL_1(a) , ::suture::dsl::a
#define SUTURE_DSL_2(a, ...) SUTURE_DSL_1(a) SUTURE_DSL_1(__VA_ARGS__)
#define SUTURE_DSL_3(a, ...) SUTURE_DSL_1(a) SUTURE_DSL_2(__VA_ARGS__)
#define SUTURE_DSL_4(a, ...) SUTURE_DSL_1(a) SUTURE_DSL_3(__VA_ARGS__)
#define SUTURE_DSL_5(a, ...) SUTURE_DSL_1(a) SUTURE_DSL_4(__VA_ARGS__)
#define SUTURE_DSL_6(a, ...) SUTURE_DSL_1(a) SUTURE_DSL_5(__VA_ARGS__)
#define SUTURE_DSL_7(a, ...) SUTURE_DSL_1(a) SUTURE_DSL_6(__VA_ARGS__)
#define SUTURE_DSL_8(a, ...) SUTURE_DSL_1(a) SUTURE_DSL_7(__VA_ARGS__)
#define SUTURE_DSL_PICK(a, b, c, d, e, f, g, h, chosen, ...) chosen
#define SUTURE_DSL(...)                                                                           \
  __VA_OPT__(SUTURE_DSL_PICK(__VA_ARGS__, SUTURE_DSL_8, SUTURE_DSL_7, SUTURE_DSL_6, SUTURE_DSL_5, \
                             SUTURE_DSL_4, SUTURE_DSL_3, SUTURE_DSL_2,                            \
                             SUTURE_DSL_1, )(__VA_ARGS__))
#define SUTURE_ANNOTATE(kind, ...) [[clang::annotate("suture::" kind SUTURE_DSL(__VA_ARGS__))]]

#define SUTURE_TYPE(...) SUTURE_ANNOTATE("type", __VA_ARGS__)
#define SUTURE_FIELD(...) SUTURE_ANNOTATE("field", __VA_ARGS__)
#define SUTURE_INTERFACE(...) SUTURE_ANNOTATE("interface", __VA_ARGS__)
#define SUTURE_COMMAND(...) SUTURE_ANNOTATE("command", __VA_ARGS__)
#define SUTURE_EVENT(...) SUTURE_ANNOTATE("event", __VA_ARGS__)
#define SUTURE_COMPONENT(...) SUTURE_ANNOTATE("component", __VA_ARGS__)

#else

#define SUTURE_TYPE(...)
#define SUTURE_FIELD(...)
#define SUTURE_INTERFACE(...)
#define SUTURE_COMMAND(...)
#define SUTURE_EVENT(...)
#define SUTURE_COMPONENT(...)

#endif
