#pragma once
// This is what one set of annotated headers declares, as plain values. The frontend fills it from
// clang's tree, check/ and lock/ judge it, emit/ writes it out. Nothing here knows clang.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/model/diagnostic.h"
#include "compiler/model/type.h"

namespace suture::compiler::model {

/// This may be said of any declaration.
struct Documentation {
  std::string text;  ///< the doc comment, markers stripped, lines joined with '\n'
};

/// A declaration says this of its own history.
struct Lifecycle {
  std::optional<unsigned> since;  ///< the version that it came with
  std::string deprecated;         ///< why it should not be used any more; "" = it may be
};

/// Says what numbers mean, and which are allowed.
struct Limits {
  std::string unit;  ///< "" = none said
  std::optional<std::pair<double, double>> range;
};

/// Says of a field that nothing gives it a value, and how that could be done.
struct Unset {
  std::string setting;     ///< "= 0", as C++ would have it there; "" = a person has to decide
  std::optional<Fix> fix;  ///< that writes it there, where that is possible
};

struct Field {
  std::string name;  ///< C++ name; of a base class: the name of its slot
  std::string wireName;
  bool isNamed = false;  ///< name() says the name on the wire
  Type type;
  bool isBase = false;    ///< a base class, not a member
  bool isHidden = false;  ///< not public: reached through suture::Members
  bool isPacked = false;  ///< no reference binds to it
  std::string unit;       ///< "" = none said
  std::optional<std::pair<double, double>> range;
  std::optional<std::string> was;
  /// This is the initialiser as JSON where it is a constant of a number, enum, duration (seconds,
  /// exact) or string; "inf" and "-inf" are words; empty = zero.
  std::string defaultJson;
  std::vector<double> defaultNumbers{};  ///< the initialiser's, if the field has several numbers
  bool isPreset = false;         ///< the struct's constructor may give it more than its type would
  std::optional<Unset> unset{};  ///< a new value has whatever its memory held
  Lifecycle lifecycle;
  Documentation doc;
  Source source;
};

struct Enumerator {
  std::string name;
  std::string wireName;
  std::int64_t value = 0;  ///< the bits, if a UInt64 is larger than any std::int64_t
  Documentation doc;
  Source source;
  bool fallback = false;  ///< stands for every enumerator that a receiver does not know
  Lifecycle lifecycle{};
  std::optional<std::string> was{};
  bool isNamed = false;  ///< name() says the name on the wire
};

struct Enum {
  std::string name;  ///< fully qualified: "robots::ArmState"
  std::string wireName;
  Scalar underlying = Scalar::Int32;
  /// This is spelled as in C++. Of an enum that cannot be edited it may be "char", which is another
  /// type than std::int8_t.
  std::string underlyingType = "std::int32_t";
  bool isOpen = false;  ///< no underlying type is declared, so that few integers are values of it
  /// As in Struct, this is the namespace of a foreign type.
  std::optional<std::string> foreignNamespace{};
  std::vector<Enumerator> enumerators;
  std::optional<std::string> was;  ///< the former C++ name, as written
  Lifecycle lifecycle;
  Documentation doc;
  Source source;
};

struct Struct {
  std::string name;  ///< fully qualified; an instance of a template has its alias's
  std::string wireName;
  /// Says where functions on it are found by their argument, if that is not its header's namespace.
  std::optional<std::string> foreignNamespace;
  bool isExternal = false;  ///< SUTURE_EXTERNAL_TYPE names it, since it cannot be edited
  std::vector<Field> fields;
  std::optional<std::string> was;  ///< the former C++ name, as written
  Lifecycle lifecycle;
  Documentation doc;
  Source source;
};

struct Parameter {
  std::string name;
  std::string wireName;
  Type type;
  bool byReference = true;  ///< const T&, else by value
  std::string unit;         ///< "" = none said
  std::optional<std::pair<double, double>> range;
  Source source;
};

/// Says how many of a command or event may wait where its header does not say it.
inline constexpr unsigned kDefaultQueue = 16;

enum class CommandKind { Void, Write, Read, QualifiedRead, VoidReturn, WriteReturn };

struct Command {
  std::string name;      ///< C++ name, also the name in descriptions: "servo_cp"
  std::string wireName;  ///< capnp's: "servoCp"
  CommandKind kind = CommandKind::Void;
  std::vector<Parameter> parameters;
  std::optional<Type> result;
  bool resultByReference = false;
  std::string resultUnit;  ///< from SUTURE_FIELD on the command; "" = none said
  std::optional<std::pair<double, double>> resultRange;
  unsigned queue = kDefaultQueue;
  bool queueGiven = false;  ///< queue() was written, not defaulted
  bool latest = false;
  std::optional<std::int64_t> ttlNanoseconds;
  std::optional<std::int64_t> deadlineNanoseconds;
  bool optional = false;  ///< a provider may lack it
  bool concurrent = false;
  bool direct = false;
  bool isOverloaded = false;  ///< the class has another method of this name, which is no command
  std::string inheritedFrom;  ///< the contract that declares it, fully qualified; "" = this one
  std::optional<unsigned> ordinal{};  ///< in the lock of that one, once it is looked up
  Lifecycle lifecycle;
  std::optional<std::string> was;
  Documentation doc;
  Source source;
  Source signature;  ///< from its name to the end of its parameters
};

struct Event {
  std::string member;          ///< C++ member: "operating_state_event"
  std::string name;            ///< name in descriptions and in emit()/on(): "operating_state"
  std::string wireName;        ///< capnp's: "operatingState"
  std::vector<Type> payload;   ///< none: a void event; else a write event
  std::vector<Limits> limits;  ///< each value's; those behind the last one have none
  unsigned queue = kDefaultQueue;
  bool queueGiven = false;  ///< queue() was written, not defaulted
  bool latest = false;
  bool latched = false;
  std::string inheritedFrom;  ///< the contract that declares it, fully qualified; "" = this one
  std::optional<unsigned> ordinal{};  ///< in the lock of that one, once it is looked up
  Lifecycle lifecycle;
  std::optional<std::string> was;
  Documentation doc;
  Source source;
};

struct Interface {
  std::string name;  ///< fully qualified
  std::string wireName;
  std::string base;               ///< the contract it derives from, fully qualified; "" = none
  std::vector<Command> commands;  ///< those of the base first
  std::vector<Event> events;      ///< those of the base first
  unsigned version = 1;
  bool crtk = false;               ///< names and payloads follow CRTK
  std::optional<std::string> was;  ///< the former C++ name, as written
  Lifecycle lifecycle;
  Documentation doc;
  Source source;
};

/// A Port is a Provided<I> or Required<I> member of a component.
struct Port {
  std::string member;
  std::string name;       ///< "Slave", where the member's initialiser says it; else ""
  std::string interface;  ///< fully qualified
  bool provided = false;
  bool optional = false;                            ///< the component works without it
  std::optional<std::int64_t> maxAgeNanoseconds{};  ///< an older value is of no use to it
  Source source;
};

enum class ComponentBase { Device, Task };

struct Component {
  std::string name;  ///< fully qualified
  ComponentBase base = ComponentBase::Task;
  std::optional<std::string> parameters;  ///< fully qualified struct that the constructor takes
  bool movesParameters = false;           ///< it takes them as an rvalue reference
  std::vector<Port> ports;
  Documentation doc;
  Source source;
};

/// A Header holds everything that one header declares, in the order of its text.
struct Header {
  std::string path;          ///< "arm/arm.h": as included, and the stem of every artefact
  std::string file;          ///< where it was read, as clang opened it
  std::string cxxNamespace;  ///< enclosing namespace of its declarations: "robots::arm"
  bool own = true;  ///< false: another target's; read for its declarations, nothing is emitted
  std::string wirePrefix{};          ///< composites' names begin with it; "" = made of the path
  bool hasDeprecated = false;        ///< the compiler warns of the use of some of it
  std::vector<std::string> imports;  ///< paths of the annotated headers whose types it uses, sorted
  std::vector<Enum> enums;
  std::vector<Struct> structs;
  std::vector<Interface> interfaces;
  std::vector<Component> components;
};

/// Says where a macro is defined.
enum class MacroOrigin { Header, CommandLine };

struct Model {
  std::vector<Header> headers;  ///< own and foreign, sorted by path
  /// The macros without parameters that are left behind the last header stand here by their names.
  std::map<std::string, MacroOrigin> macros{};
};

}  // namespace suture::compiler::model
