"""Edits after which old and new peers must not talk: suturec refuses them, and who accepts the break is refused by the wire."""

import dataclasses

from edit import BREAKS, NOTHING, Command, Edit, Event, Side, second_contract


def record(body, **more):
    return Side(types="struct SUTURE_TYPE() {T} {\n%s\n};\n" % body, **more)


def field(name, page, before, after, refusal, also=""):
    return Edit(name, page, record("  %s;" % before), record("  %s;" % after), "lock-break" + also, "lock-break", diff=BREAKS,
                refusal=refusal)


def command(name, page, before, after, refusal, also=""):
    return Edit(name, page, Side(commands=before), Side(commands=after), "lock-break" + also, "lock-break", diff=BREAKS,
                refusal=refusal)


UNLIKE = ("", "")  # only the majors tell the two apart
KEEPS = "struct SUTURE_TYPE() {T}Rest {\n  std::optional<float> b;\n};\n"
MOVES = "struct SUTURE_TYPE() {T} {\n  std::optional<float> a;\n};\n"
TYPE, UNIT = "a type", "a unit, a period of time, a clock, a shape"

FIELDS = [
    field("int32 becomes int64", TYPE, "std::int32_t a = 7", "std::int64_t a = 7", ("", "Int32 = 7")),
    field("float becomes double", TYPE, "float a = 1.5f", "double a = 1.5", ("Float64 = 1.5", "Float32 = 1.5")),
    field("double becomes int", TYPE, "double a = 1.5", "std::int32_t a = 7", ("Int32 = 7", "Float64 = 1.5")),
    field("string becomes vector", TYPE, "SUTURE_FIELD(capacity(4)) std::string a", "SUTURE_FIELD(capacity(4)) std::vector<double> a",
          ("List(Float64)", "Text")),
    field("optional put around a field", TYPE, "std::int32_t a = 7", "std::optional<std::int32_t> a", ("", "Int32 = 7"),
          also=" lock-new"),
    field("optional taken from a field", TYPE, "std::optional<std::int32_t> a", "std::int32_t a = 7", ("Int32 = 7", ""),
          also=" lock-removed"),
    field("length of an array changed", UNIT, "std::array<double, 2> a{}", "std::array<double, 3> a{}", ('shape "3"', 'shape "2"')),
    field("unit changed", UNIT, 'SUTURE_FIELD(unit("m")) double a = 0', 'SUTURE_FIELD(unit("mm")) double a = 0',
          ('unit "mm"', 'unit "m"')),
    field("period of a duration changed", UNIT, "std::chrono::milliseconds a{7}", "std::chrono::microseconds a{7}",
          ('period "1/1000000" = 7000', 'period "1/1000" = 7000000')),
    Edit("type moved from a header where its optional stays", "a type moved away from an optional that stays",
         Side(types=KEEPS + MOVES), Side(types=KEEPS, elsewhere=MOVES), "lock-missing lock-moved", "lock-break", diff=BREAKS,
         refusal=UNLIKE),
]

LAST = Command("void last()")
MOVE = Command("void move(std::int32_t a, double speed)")

COMMANDS = [
    command("command removed", "a command, an event, a contract removed", (Command("void gone()"), LAST), (LAST,),
            UNLIKE),
    command("last command removed", "a command, an event, a contract removed", (LAST, Command("void gone()")), (LAST,),
            UNLIKE),
    command("command renamed without was", "a command, an event, a contract removed",
            (Command("void before()"), LAST), (Command("void behind()"), LAST), UNLIKE, also=" lock-new"),
    command("write made to return", "the kind of a command", (Command("void set(double a)"),),
            (Command("double set(double a)", gives="a"),), ('kind "writeReturn"', 'kind "write"'),
            also=" lock-new"),
    command("read made qualified", "the kind of a command", (Command("double level() const", gives="1"),),
            (Command("double level(double a) const", gives="a"),), ('kind "qualifiedRead"', 'kind "read"'),
            also=" lock-new lock-removed"),
    command("parameter removed", "a parameter removed or renamed", (MOVE,), (Command("void move(std::int32_t a)"),),
            ("/suture/rpc.capnp:Sent", "Float64")),
    command("parameter renamed", "a parameter removed or renamed", (MOVE,),
            (Command("void move(std::int32_t a, double pace)"),), UNLIKE, also=" lock-new"),
    command("type of a parameter changed", TYPE, (MOVE,), (Command("void move(std::int32_t a, float speed)"),),
            ("Float32", "Float64")),
]

EVENTS = [
    Edit("event removed", "a command, an event, a contract removed",
         Side(events=(Event("gone_event", "double"), Event("last_event", "double"))),
         Side(events=(Event("last_event", "double"),)),
         "lock-break", "lock-break", diff=BREAKS, refusal=UNLIKE),
    Edit("event renamed without was", "a command, an event, a contract removed",
         Side(events=(Event("before_event", "double"), Event("last_event", "double"))),
         Side(events=(Event("behind_event", "double"), Event("last_event", "double"))),
         "lock-break lock-new", "lock-break", diff=BREAKS, refusal=UNLIKE),
    Edit("payload of an event changed", TYPE, Side(events=(Event("moved_event", "double"),)),
         Side(events=(Event("moved_event", "std::int32_t"),)), "lock-break", "lock-break", diff=BREAKS,
         refusal=("Int32", "Float64")),
]

BASE = "class SUTURE_INTERFACE() {T}Base {\n public:\n  virtual ~{T}Base() = default;\n%s};\n" % LAST.declaration()

CONTRACTS = [
    Edit("version raised", "`version(n)`", Side(), Side(says="version(2)"), "lock-break", "lock-break", diff=BREAKS,
         refusal=("version(2)", "version(1)")),
    Edit("base of a contract added", "a base of a contract, added or removed", Side(types=BASE), Side(types=BASE, base="{T}Base"),
         "lock-break", "lock-break", diff=BREAKS, refusal=UNLIKE),
    Edit("base of a contract removed", "a base of a contract, added or removed", Side(types=BASE, base="{T}Base"), Side(types=BASE),
         "lock-break", "lock-break", diff=BREAKS, refusal=UNLIKE),
]

BREAKING = FIELDS + COMMANDS + EVENTS + CONTRACTS

# A peer of before asks for what the other one does not have at all, so no pair of programs is built for these.
GONE = [
    Edit("contract removed", "a command, an event, a contract removed", second_contract("Gone"), Side(),
         "lock-break lock-removed", "lock-break", diff=BREAKS),
    Edit("contract renamed without was", "a command, an event, a contract removed", second_contract("Before"), second_contract("Behind"),
         "lock-break lock-new lock-removed", "lock-break", diff=BREAKS),
]

SWAPPED = "two names, exchanged by `was()`"

# The lock does not say whether it is the member or the base that it knows; name() on the member says so.
BASE_STRUCT = "struct SUTURE_TYPE() {T}Base {\n  double a = 1;\n};\n"
MEMBER = "  {T}Base base;"

# No tool can accept these: no lock tells what is meant, or capnp's C++ would have one name twice.
IMPOSSIBLE = [
    Edit("base added beside a member of its type called base", "a field or a base",
         Side(types=BASE_STRUCT + "struct SUTURE_TYPE() {T} {\n%s\n};\n" % MEMBER),
         Side(types=BASE_STRUCT + "struct SUTURE_TYPE() {T} : {T}Base {\n%s\n};\n" % MEMBER),
         "wire-name-clash", "wire-name-clash", "wire-name-clash", NOTHING),
    Edit("two names swapped with was", SWAPPED, record("  double a = 1;\n  double b = 2;"),
         record('  SUTURE_FIELD(was("b")) double a = 1;\n  SUTURE_FIELD(was("a")) double b = 2;'),
         "exchanged-names", "exchanged-names", "exchanged-names", NOTHING),
    Edit("two types swapped with was", SWAPPED,
         Side(types="struct SUTURE_TYPE() {T}A {\n  double a = 1;\n};\nstruct SUTURE_TYPE() {T}B {\n  bool b = true;\n};\n"),
         Side(types='struct SUTURE_TYPE(was("{T}B")) {T}A {\n  double a = 1;\n};\n'
                    'struct SUTURE_TYPE(was("{T}A")) {T}B {\n  bool b = true;\n};\n'),
         "exchanged-names", "exchanged-names", "exchanged-names", NOTHING),
    Edit("namespace changed", "a namespace, without `was()`", record("  double a = 1;"),
         dataclasses.replace(record("  double a = 1;"), space="moved"),
         "lock-break lock-new lock-removed wire-name-clash", "lock-break wire-name-clash", "wire-name-clash", NOTHING),
]
