#pragma once
// This is the annotation vocabulary: an engineer writes it in a header so that suturec can read it.
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
#include <string_view>

namespace suture {

class Component;

/// Declares an event inside a contract. It is a tag without state: only Provided emits an event,
/// only Required subscribes to one. `EventOf<>` is a void event, `EventOf<T>` and `EventOf<T, U>`
/// are write events.
template <class... Arguments>
struct EventOf {};

/// Specialise it for a type that suturec cannot look into; it then travels as `Type`, which has a
/// wire form of its own:
///   using Type = ...;
///   static Type to(const T&);
///   static T from(const Type&);
template <class T>
struct Wire;

/// suturec writes this; it reaches the members of a T that has SUTURE_FRIEND().
template <class T>
struct Members;

#ifdef SUTUREC  // it reads headers before anything is generated from them
template <class>
inline constexpr bool hasGeneratedHeader = true;
#else
template <class>
inline constexpr bool hasGeneratedHeader = false;
#endif

/// Stands in each template that suturec specialises for `Declared`, in the header that it
/// generates: who uses one without that is told so.
template <class Declared>
struct Generated {
  static_assert(hasGeneratedHeader<Declared>,
                "include \"X.suture.h\" in place of the \"X.h\" that declares it: the build writes "
                "X.suture.h, which includes X.h");
  /// A function that has to be specialised returns this.
  template <class Result>
  static Result result();
};

/// A Required is a component's required interface of type Contract. Each contract's generated
/// header specialises it:
///   Required<Arm> slave_{*this, "Slave"};
///   slave_.servo_cp(goal);
template <class Contract>
class Required : Generated<Contract> {
 public:
  Required(Component& owner, std::string_view name);
};

/// A Provided is a component's provided interface of type Contract. Each contract's generated
/// header specialises it:
///   Provided<Arm> arm_{*this, "Arm", *this};
///   arm_.emit().operating_state(value);
template <class Contract>
class Provided : Generated<Contract> {
 public:
  Provided(Component& owner, std::string_view name, Contract& implementation);
};

}  // namespace suture

/// Stands inside a SUTURE_TYPE whose private members are to be on the wire too. No semicolon stands
/// behind it.
#define SUTURE_FRIEND()       \
  template <class SutureType> \
  friend struct ::suture::Members;

#ifdef SUTUREC

using namespace std::chrono_literals;

// These functions are constexpr and not consteval, because clang 19 crashes on a consteval call in
// the annotation of a nested struct's member that has a default, where std::optional holds that
// struct.
namespace suture::dsl {

using Nanoseconds = std::chrono::nanoseconds;

struct Unit {
  const char* symbol;
};
struct Range {
  double lowest, highest;
};
struct Capacity {
  unsigned first, second, third, fourth, fifth, sixth, seventh, eighth;
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
struct Deadline {
  long long nanoseconds;
};
struct MaxAge {
  long long nanoseconds;
};
struct Optional {
  bool set;
};
struct Concurrent {
  bool set;
};
struct Direct {
  bool set;
};
struct Crtk {
  bool set;
};
struct Version {
  unsigned number;
};
struct Since {
  unsigned version;
};
struct Deprecated {
  const char* why;
};
struct Skip {
  bool set;
};
struct Fallback {
  bool set;
};
struct Bulk {
  bool set;
};
struct All {
  bool set;
};
template <class Pointer, class... Arguments>
struct Member : Arguments... {
  Pointer pointer;
};

/// Names the unit of a number, SI or derived: "m", "rad", "m/s", "N.m".
constexpr Unit unit(const char* symbol) { return {symbol}; }
/// Sets the range, including both ends, which both ends enforce.
constexpr Range range(double lowest, double highest) { return {lowest, highest}; }
/// Sets the upper bounds of strings, lists, maps (one number each) and matrices (rows, columns),
/// from the outside in.
template <class... Bounds>
constexpr Capacity capacity(unsigned first, Bounds... more) {
  static_assert(sizeof...(more) < 8, "a type has at most eight bounds");
  return {first, static_cast<unsigned>(more)...};
}
/// Says which name this had before, so that it keeps its place on the wire.
constexpr Was was(const char* name) { return {name}; }
/// Sets the name on the wire, if it cannot be the C++ name.
constexpr Name name(const char* wireName) { return {wireName}; }
/// Sets how many of this command or event may wait.
constexpr Queue queue(unsigned depth) { return {depth}; }
/// Says that only the newest counts, which replaces an older one that waits.
constexpr Latest latest() { return {true}; }
/// Sets the age beyond which a command is discarded when its turn comes, and counted as late.
constexpr Ttl ttl(Nanoseconds age) { return {age.count()}; }
/// Says that a client that subscribes later receives the last value.
constexpr Latched latched() { return {true}; }
/// Sets how long within() waits for the answer of this command if neither the call nor the
/// connection's contract says.
constexpr Deadline deadline(Nanoseconds limit) { return {limit.count()}; }
/// Says that a provider may lack this command, or that this required interface may stay
/// unconnected.
constexpr Optional optional() { return {true}; }
/// Says that a qualified read may run beside the component, in the thread of a caller in the same
/// process. For other callers it runs in the component's own thread.
constexpr Concurrent concurrent() { return {true}; }
/// Says that a command needs no queue because it only touches atomics: it runs at once, before what
/// waits in the queue, in the thread of a caller in the same process. For other callers it is
/// queued and runs in the component's own thread.
constexpr Direct direct() { return {true}; }
/// Says that the names and payloads of this contract follow CRTK, which suturec checks.
constexpr Crtk crtk() { return {true}; }
/// Sets the major version of a contract. Two versions do not connect.
constexpr Version version(unsigned number) { return {number}; }
/// Says with which version this came: of its contract, or of what the project calls one.
constexpr Since since(unsigned version) { return {version}; }
/// Makes the compiler warn where this is still used, and give the reason.
constexpr Deprecated deprecated(const char* why) { return {why}; }
/// Sets the age beyond which values are stale to the component, unless a connection says otherwise.
constexpr MaxAge max_age(Nanoseconds age) { return {age.count()}; }
/// Says that the field is not part of the value, and stays in this process.
constexpr Skip skip() { return {true}; }
/// Makes a receiver use this enumerator for each one that it does not know.
constexpr Fallback fallback() { return {true}; }
/// Makes a list or matrix of numbers travel as one block of little-endian bytes, which is faster to
/// copy, and which a program in another language cannot read without knowing this.
constexpr Bulk bulk() { return {true}; }
/// Puts all public members of an external type on the wire. Those that are listed too have their
/// own annotations, of which skip() takes one out.
constexpr All all() { return {true}; }
/// Names a member of an external type, with what would stand in its SUTURE_FIELD.
template <class Pointer, class... Arguments>
constexpr Member<Pointer, Arguments...> member(Pointer pointer, Arguments... arguments) {
  return {arguments..., pointer};
}

/// Stands for a value of an external type where a member is only named.
template <class T>
T& any();

}  // namespace suture::dsl

// This qualifies each argument with ::suture::dsl:: (up to eight of them).
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
#define SUTURE_REQUIRED(...) SUTURE_ANNOTATE("required", __VA_ARGS__)

// Each item of SUTURE_EXTERNAL_TYPE is all(), name("..."), member(m, ...) or the plain name of a
// member, and becomes a dsl call. Pasting finds out which it is, because only the first three are
// macros then.
#define SUTURE_ITEM_member(...) ~, SUTURE_ITEM_ANNOTATED
#define SUTURE_ITEM_name(...) ~, SUTURE_ITEM_CALL
#define SUTURE_ITEM_all(...) ~, SUTURE_ITEM_CALL
#define SUTURE_ITEM_CHOOSE(ignored, chosen, ...) chosen
#define SUTURE_ITEM_KIND(...) SUTURE_ITEM_CHOOSE(__VA_ARGS__)
#define SUTURE_ITEM(item) \
  , SUTURE_ITEM_KIND(SUTURE_ITEM_##item, SUTURE_ITEM_PLAIN, )(item, SUTURE_OPEN_##item)
#define SUTURE_ITEM_PLAIN(item, ...) ::suture::dsl::member(&Type::item)
#define SUTURE_ITEM_CALL(item, ...) ::suture::dsl::item
#define SUTURE_ITEM_ANNOTATED(item, ...) ::suture::dsl::member(__VA_ARGS__)
// Nothing can point to a bit-field, so a member that is skipped is only mentioned.
#define SUTURE_OPEN_member(m, ...) \
  SUTURE_ITEM_KIND(SUTURE_SAYS(__VA_ARGS__), SUTURE_POINTER, )(m) SUTURE_DSL(__VA_ARGS__)
#define SUTURE_SAYS(first, ...) SUTURE_SAYS_##first
#define SUTURE_SAYS_skip(...) ~, SUTURE_MENTION
#define SUTURE_POINTER(m) &Type::m
#define SUTURE_MENTION(m) noexcept(::suture::dsl::any<Type>().m)
#define SUTURE_AGAIN() SUTURE_ITEMS_LOOP
#define SUTURE_ITEMS_LOOP(item, ...) \
  SUTURE_ITEM(item) __VA_OPT__(SUTURE_AGAIN SUTURE_LATER()()(__VA_ARGS__))
#define SUTURE_LATER()
#define SUTURE_SCAN_1(...) __VA_ARGS__
#define SUTURE_SCAN_2(...) SUTURE_SCAN_1(SUTURE_SCAN_1(SUTURE_SCAN_1(__VA_ARGS__)))
#define SUTURE_SCAN_3(...) SUTURE_SCAN_2(SUTURE_SCAN_2(SUTURE_SCAN_2(__VA_ARGS__)))
#define SUTURE_SCAN_4(...) SUTURE_SCAN_3(SUTURE_SCAN_3(SUTURE_SCAN_3(__VA_ARGS__)))
#define SUTURE_SCAN_5(...) SUTURE_SCAN_4(SUTURE_SCAN_4(SUTURE_SCAN_4(__VA_ARGS__)))
#define SUTURE_SCAN_6(...) SUTURE_SCAN_5(SUTURE_SCAN_5(SUTURE_SCAN_5(__VA_ARGS__)))
#define SUTURE_SCAN(...) SUTURE_SCAN_6(SUTURE_SCAN_6(SUTURE_SCAN_6(__VA_ARGS__)))
#define SUTURE_ITEMS(...) __VA_OPT__(SUTURE_SCAN(SUTURE_ITEMS_LOOP(__VA_ARGS__)))
#define SUTURE_JOIN_NOW(a, b) a##b
#define SUTURE_JOIN(a, b) SUTURE_JOIN_NOW(a, b)

#define SUTURE_EXTERNAL_TYPE(T, ...)                                                         \
  struct SUTURE_JOIN(SutureExternalType, __COUNTER__) {                                      \
    using Type = T;                                                                          \
    [[clang::annotate("suture::external" SUTURE_ITEMS(__VA_ARGS__))]] static void members(); \
  }

#else

#define SUTURE_TYPE(...)
#define SUTURE_FIELD(...)
#define SUTURE_INTERFACE(...)
#define SUTURE_COMMAND(...)
#define SUTURE_EVENT(...)
#define SUTURE_COMPONENT(...)
#define SUTURE_REQUIRED(...)
/// Stands at namespace scope, for a struct or enum that cannot be edited. Without a list, or with
/// all(), each public member is on the wire; otherwise those that are listed, by name or as
/// member(m, unit("m"), ...). A semicolon stands behind it.
#define SUTURE_EXTERNAL_TYPE(T, ...) static_assert(true)

#endif
