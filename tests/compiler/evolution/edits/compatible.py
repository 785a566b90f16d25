"""Lists edits after which old and new peers work together. What a range or a capacity refuses is among the calls."""

from edit import FINE, NOTHING, REFUSES, Call, Command, Edit, Event, Side, second_contract

OUTSIDE = "value outside its declared limits"
LONGER = "larger than the declared capacity"

LIMIT = "a capacity, a range, the representation of a duration"
SET = "a `std::vector` that becomes a set, or back"
POLICY = "a queue, `latest()`, `latched()`, `ttl()`, `deadline()`"


def record(body, **more):
    return Side(types="struct SUTURE_TYPE() {T} {\n%s\n};\n" % body, **more)


def based(body):
    return ("struct SUTURE_TYPE() {T}Base {\n  std::int32_t id = 7;\n};\n"
            "struct SUTURE_TYPE() {T} : {T}Base {\n%s\n};\n" % body)


def record_of_bases(bases, **more):
    return Side(types="struct SUTURE_TYPE() {T}Left {\n  std::int32_t id = 2;\n};\n"
                      "struct SUTURE_TYPE() {T}Right {\n  double mass = 3;\n};\n"
                      "struct SUTURE_TYPE() {T} : %s {\n};\n" % bases, **more)


def commands(*listed):
    return Side(commands=listed)


FIELDS = [
    Edit("field added", "a field or a base",
         record("  std::int32_t a = 1;", sends={"a": "5"}, sees={"a": "6"}),
         record('  double b = 2.5;\n  std::int32_t a = 1;\n  SUTURE_FIELD(capacity(4)) std::string c = "c";',
                sends={"a": "6", "b": "7.5", "c": '"d"'}, sees={"a": "5", "b": "2.5", "c": "'c'"}),
         build="lock-new"),
    Edit("field removed", "a field removed",
         record("  std::int32_t a = 1;\n  double b = 2.5;", sends={"a": "5", "b": "7.5"}, sees={"a": "6", "b": "2.5"}),
         record("  std::int32_t a = 1;", sends={"a": "6"}, sees={"a": "5"}),
         build="lock-removed"),
    Edit("field renamed with was", "a name, by `was()`",
         record("  double a = 1;", sends={"a": "5"}, sees={"a": "6"}),
         record('  SUTURE_FIELD(was("a")) double b = 1;', sends={"b": "6"}, sees={"b": "5"}),
         build="lock-renamed"),
    # A plain build asks, --update-lock does not.
    Edit("field renamed without was", "a name, without `was()`",
         record("  std::int32_t a = 1;", sends={"a": "5"}, sees={"a": "1"}),
         record("  std::int32_t b = 2;", sends={"b": "6"}, sees={"b": "2"}),
         build="lock-new lock-removed"),
    Edit("fields reordered", "the order of declarations",
         record("  double a = 1;\n  double b = 2;", sends={"a": "5", "b": "6"}, sees={"a": "7", "b": "8"}),
         record("  double b = 2;\n  double a = 1;", sends={"a": "7", "b": "8"}, sees={"a": "5", "b": "6"}),
         diff=NOTHING),
    Edit("bases reordered", "the order of declarations",
         record_of_bases("{T}Left, {T}Right", sends={"id": "5", "mass": "6"}, sees={"id": "7", "mass": "8"}),
         record_of_bases("{T}Right, {T}Left", sends={"id": "7", "mass": "8"}, sees={"id": "5", "mass": "6"}),
         diff=NOTHING),
    Edit("base of a struct added in front of another", "a field or a base",
         record_of_bases("{T}Left", sends={"id": "5"}, sees={"id": "7"}),
         record_of_bases("{T}Right, {T}Left", sends={"id": "7", "mass": "8"}, sees={"id": "5", "mass": "3"}), build="lock-new"),
    # The peer whose default changed later still takes what the lock had first, from peers that do not send it.
    Edit("default changed", "a default",
         record("  double a = 1;", sends={"a": "5"}, sees={"a": "6"}),
         record("  double a = 2;\n  double b = 9;", sends={"a": "6"}, sees={"a": "5", "b": "3"}),
         build="lock-stale", between=record("  double a = 1;\n  double b = 3;")),
    Edit("default of both changed", "a default",
         record("  double a = 1;", sees={"a": "2"}), record("  double a = 2;", sees={"a": "1"}), build="lock-stale"),
    Edit("field documented", "a comment",
         record("  double a = 1;", sees={"a": "1"}), record("  double a = 1;  ///< A number.", sees={"a": "1"}), diff=NOTHING),
    Edit("field deprecated", "`deprecated()`",
         record("  double a = 1;", sees={"a": "1"}),
         record('  SUTURE_FIELD(deprecated("use b")) double a = 1;', sees={"a": "1"}), build="lock-stale"),
    Edit("base of a struct added", "a field or a base",
         record("  double a = 1;", sends={"a": "5"}, sees={"a": "6"}),
         Side(types=based("  double a = 1;"), sends={"a": "6", "id": "8"}, sees={"a": "5", "id": "7"}),
         build="lock-new"),
    # The zero of the wire is the first enumerator, and that of C++ the one whose value is 0.
    Edit("enum added whose first enumerator is not its zero", "a field or a base",
         record("  std::int32_t a = 1;", sends={"a": "5"}, sees={"a": "6"}),
         Side(types="enum class SUTURE_TYPE() {T}Mode : std::int8_t { Error = -1, Idle, Run };\n"
                    "struct SUTURE_TYPE() {T} {\n  std::int32_t a = 1;\n  {T}Mode braces{};\n  {T}Mode call = {T}Mode();\n};\n",
              sends={"a": "6", "braces": "{T}Mode::Run", "call": "{T}Mode::Run"},
              sees={"a": "5", "braces": "0", "call": "0"}),
         build="lock-new"),
    # What the lock knows keeps its name on the wire, wherever it stands now.
    Edit("field added that clashes on the wire", "a field or a base",
         record("  std::int32_t Gain = 1;", sends={"Gain": "5"}, sees={"Gain": "6"}),
         record("  std::int32_t gain = 2;\n  std::int32_t Gain = 1;",
                sends={"gain": "7", "Gain": "6"}, sees={"gain": "2", "Gain": "5"}),
         build="lock-new"),
    Edit("fields that clash on the wire reordered", "the order of declarations",
         record("  double low_gain = 1;\n  double lowGain = 2;", sends={"low_gain": "5", "lowGain": "6"},
                sees={"low_gain": "7", "lowGain": "8"}),
         record("  double lowGain = 2;\n  double low_gain = 1;", sends={"low_gain": "7", "lowGain": "8"},
                sees={"low_gain": "5", "lowGain": "6"}),
         diff=NOTHING),
    Edit("one of two fields that clash on the wire removed", "a field removed",
         record("  double high_gain = 1;\n  double highGain = 2;", sends={"high_gain": "5", "highGain": "6"},
                sees={"high_gain": "1", "highGain": "8"}),
         record("  double highGain = 2;", sends={"highGain": "8"}, sees={"highGain": "6"}),
         build="lock-removed"),
    Edit("member called base added beside a base", "a field or a base",
         Side(types=based("  double a = 1;"), sends={"a": "5", "id": "6"}, sees={"a": "7", "id": "8"}),
         Side(types=based("  double base = 2;\n  double a = 1;"), sends={"a": "7", "id": "8", "base": "9"},
              sees={"a": "5", "id": "6", "base": "2"}),
         build="lock-new"),
    Edit("base added beside a member called base", "a field or a base",
         record("  double base = 2;", sends={"base": "5"}, sees={"base": "8"}),
         Side(types=based("  double base = 2;"), sends={"id": "9", "base": "8"}, sees={"id": "7", "base": "5"}),
         build="lock-new"),
    Edit("base added beside a member of its type that name() calls base", "a field or a base",
         Side(types=based("  {T}Base base;").replace(" : {T}Base", ""), sends={"base.id": "5"}, sees={"base.id": "8"}),
         Side(types=based('  SUTURE_FIELD(name("base")) {T}Base base;'), sends={"id": "9", "base.id": "8"},
              sees={"id": "7", "base.id": "5"}),
         build="lock-new"),
    Edit("struct renamed with was", "a name, by `was()`",
         Side(types="struct SUTURE_TYPE() {T}Inner {\n  double a = 1;\n};\n"
                    "struct SUTURE_TYPE() {T} {\n  {T}Inner inner;\n};\n", sends={"inner.a": "5"}, sees={"inner.a": "6"}),
         Side(types='struct SUTURE_TYPE(was("{T}Inner")) {T}Part {\n  double a = 1;\n};\n'
                    "struct SUTURE_TYPE() {T} {\n  {T}Part inner;\n};\n", sends={"inner.a": "6"}, sees={"inner.a": "5"}),
         build="lock-renamed"),
    Edit("struct moved to another namespace with was", "a namespace, by `was()`",
         Side(types="struct SUTURE_TYPE() {T}Inner {\n  double a = 1;\n};\n"
                    "struct SUTURE_TYPE() {T} {\n  {T}Inner inner;\n};\n", sends={"inner.a": "5"}, sees={"inner.a": "6"}),
         Side(types='namespace moved {\nstruct SUTURE_TYPE(was("edits::{T}Inner")) {T}Inner {\n  double a = 1;\n};\n}\n'
                    "struct SUTURE_TYPE() {T} {\n  moved::{T}Inner inner;\n};\n", sends={"inner.a": "6"}, sees={"inner.a": "5"}),
         build="lock-stale"),
]

WHOLE = "struct SUTURE_TYPE() {T} {\n  %s part;\n};\n"
PART = "struct SUTURE_TYPE(%s) {T}%s {\n%s  double a = 1;\n};\n"
MOVED = "a type moved to another header"


def moved(name, part, new_part, whole=WHOLE % "{T}Part", new_whole=WHOLE % "{T}Part", **more):
    """A struct or an enum goes from the contract's header to another one, and what has it is as before."""
    return Edit(name, MOVED, Side(types=part + whole, sends={"part.a": "5"}, sees={"part.a": "6"}),
                Side(types=new_whole, elsewhere=new_part, sends={"part.a": "6"}, sees={"part.a": "5"}),
                **{"build": "lock-missing lock-moved", **more})


DEEP = "struct SUTURE_TYPE() {T}Deep {\n  double a = 1;\n};\n"
IN_SPACE = "namespace moved {\n%s}\n"

MOVES = [
    moved("type moved to another header", PART % ("", "Part", ""), PART % ("", "Part", "")),
    moved("type renamed and moved to another header with was", PART % ("", "Part", ""), PART % ('was("{T}Part")', "Piece", ""),
          new_whole=WHOLE % "{T}Piece"),
    moved("type moved to another header under another wire name", PART % ("", "Part", ""), PART % ('name("{T}There")', "Part", "")),
    moved("type moved to another header and namespace with was", PART % ("", "Part", ""),
          IN_SPACE % PART % ('was("edits::{T}Part")', "Part", ""), new_whole=WHOLE % "moved::{T}Part"),
    moved("type moved to another header with its composites", DEEP + PART % ("", "Part", "  std::optional<{T}Deep> deep;\n"),
          DEEP + PART % ("", "Part", "  std::optional<{T}Deep> deep;\n")),
    Edit("enum moved to another header", MOVED,
         Side(types="enum class SUTURE_TYPE() {T}Mode { Off, On };\nstruct SUTURE_TYPE() {T} {\n  {T}Mode mode = {T}Mode::On;\n};\n",
              sends={"mode": "{T}Mode::Off"}, sees={"mode": "1"}),
         Side(elsewhere="enum class SUTURE_TYPE() {T}Mode { Off, On };\n",
              types="struct SUTURE_TYPE() {T} {\n  {T}Mode mode = {T}Mode::On;\n};\n",
              sends={"mode": "{T}Mode::On"}, sees={"mode": "0"}),
         build="lock-missing lock-moved"),
    Edit("type of another header renamed with was", "a name, by `was()`",
         Side(elsewhere=PART % ("", "Part", ""), types=WHOLE % "{T}Part", sends={"part.a": "5"}, sees={"part.a": "6"}),
         Side(elsewhere=PART % ('was("{T}Part")', "Piece", ""), types=WHOLE % "{T}Piece", sends={"part.a": "6"},
              sees={"part.a": "5"}),
         build="lock-moved lock-renamed"),
    Edit("type moved from another header", MOVED,
         Side(elsewhere=PART % ("", "Part", "") + DEEP, types=WHOLE % "{T}Part", sends={"part.a": "5"}, sees={"part.a": "6"}),
         Side(elsewhere=DEEP, types=PART % ("", "Part", "") + WHOLE % "{T}Part", sends={"part.a": "6"}, sees={"part.a": "5"}),
         build="lock-moved"),
]


def mode(enumerators, **more):
    return Side(types="enum class SUTURE_TYPE() {T}Mode { %s };\n" % enumerators +
                "struct SUTURE_TYPE() {T} {\n  {T}Mode mode = {T}Mode::Off;\n};\n",
                sends={"mode": "{T}Mode::On"}, sees={"mode": "1"}, **more)


def chooses(name, *calls):
    return (Command("void %s({T}Mode mode)" % name, calls=calls),)


ENUMERATORS = [
    Edit("enumerator added", "an enumerator, an alternative of a variant",
         mode("Off, On", commands=chooses("choose")),
         mode("Off, On, Fast", commands=chooses("choose", Call("{T}Mode::On", heard="mode=1"),
                                                Call("{T}Mode::Fast", OUTSIDE, heard=None))),
         build="lock-new", diff=REFUSES),
    Edit("enumerator added that clashes on the wire", "an enumerator, an alternative of a variant",
         mode("Off, On", commands=chooses("choose_one")),
         mode("Off, on = 5, On = 1", commands=chooses("choose_one", Call("{T}Mode::On", heard="mode=1"),
                                                      Call("{T}Mode::on", OUTSIDE, heard=None))),
         build="lock-new", diff=REFUSES),
    # The lock says nothing of a fallback, so diff speaks of refusals here too.
    Edit("enumerator added to an enum with fallback", "an enumerator, an alternative of a variant",
         mode("Off SUTURE_FIELD(fallback()), On", commands=chooses("choose_known")),
         mode("Off SUTURE_FIELD(fallback()), On, Fast",
              commands=chooses("choose_known", Call("{T}Mode::Fast", heard="mode=0"))),
         build="lock-new", diff=REFUSES),
    Edit("fallback removed", "`fallback()`",
         mode("Off SUTURE_FIELD(fallback()), On", commands=chooses("choose_any")),
         mode("Off, On", commands=chooses("choose_any")), build="lock-range", diff=REFUSES),
    Edit("fallback moved", "`fallback()`",
         mode("Off SUTURE_FIELD(fallback()), On", commands=chooses("choose_other")),
         mode("Off, On SUTURE_FIELD(fallback())", commands=chooses("choose_other")), build="lock-stale"),
    Edit("fallback added", "`fallback()`",
         mode("Off, On", commands=chooses("choose_safely")),
         mode("Off SUTURE_FIELD(fallback()), On", commands=chooses("choose_safely")), build="lock-stale"),
    Edit("enumerator removed", "an enumerator removed",
         mode("Off, On, Fast", commands=chooses("choose_gone", Call("{T}Mode::On", heard="mode=1"),
                                                Call("{T}Mode::Fast", OUTSIDE, heard=None))),
         mode("Off, On", commands=chooses("choose_gone")),
         build="lock-removed", diff=REFUSES),
    Edit("enumerator renamed with was", "a name, by `was()`",
         mode("Off, On"),
         Side(types="enum class SUTURE_TYPE() {T}Mode { Off, Up SUTURE_FIELD(was(\"On\")) };\n"
                    "struct SUTURE_TYPE() {T} {\n  {T}Mode mode = {T}Mode::Off;\n};\n",
              sends={"mode": "{T}Mode::Up"}, sees={"mode": "1"}),
         build="lock-renamed"),
    Edit("value of an enumerator changed", "the value of an enumerator",
         Side(types=mode("Off, On").types, sends={"mode": "{T}Mode::On"}, sees={"mode": "1"}),
         Side(types=mode("Off, On = 9").types, sends={"mode": "{T}Mode::On"}, sees={"mode": "9"}),
         build="lock-stale"),
    Edit("alternative of a variant added", "an enumerator, an alternative of a variant",
         record("  std::variant<double, bool> a;", sends={"a": "true"}, sees={"a": "1:1"},
                commands=(Command("void pick(const {T}& value)"),)),
         record("  std::variant<std::int32_t, double, bool> a;", sends={"a": "true"}, sees={"a": "2:1"},
                commands=(Command("void pick(const {T}& value)", calls=(Call("{T}{{7}}", OUTSIDE, heard=None),)),)),
         build="lock-new lock-renamed", diff=REFUSES),
]


def ranged(name, range_, *calls):
    return record("  SUTURE_FIELD(%s) double a = 1;" % range_, sends={"a": "2"}, sees={"a": "2"},
                  commands=(Command("void %s(const {T}& value)" % name, calls=calls),))


def bounded(name, capacity, *calls):
    return record('  SUTURE_FIELD(capacity(%s)) std::string a = "a";' % capacity, sends={"a": '"b"'}, sees={"a": "'b'"},
                  commands=(Command("void %s(const {T}& value)" % name, calls=calls),))


def ticks(representation, *calls):
    """A command that takes milliseconds, counted by such an integer."""
    return Side(types="using {T}Ticks = std::chrono::duration<%s, std::milli>;\n" % representation,
                commands=(Command("void pause({T}Ticks a, const std::optional<{T}Ticks>& b)", calls=calls),))


def collected(name, container, *calls):
    return record("  SUTURE_FIELD(capacity(4)) std::%s<std::int32_t> a;" % container,
                  commands=(Command("void %s(const {T}& value)" % name, calls=calls),))


LIMITS = [
    Edit("range narrowed", LIMIT,
         ranged("narrow", "range(0, 10)", Call("{T}{4}", heard="value={4}"), Call("{T}{8}", OUTSIDE, heard=None)),
         ranged("narrow", "range(0, 5)", Call("{T}{4}", heard="value={4}")), build="lock-range", diff=REFUSES),
    Edit("range widened", LIMIT,
         ranged("widen", "range(0, 5)", Call("{T}{4}", heard="value={4}")),
         ranged("widen", "range(0, 10)", Call("{T}{4}", heard="value={4}"), Call("{T}{8}", OUTSIDE, heard=None)),
         build="lock-range", diff=REFUSES),
    Edit("capacity lowered", LIMIT,
         bounded("shorten", "4", Call('{T}{"four"}', LONGER, heard=None)),
         bounded("shorten", "2", Call('{T}{"2x"}', heard="value={'2x'}")), build="lock-range", diff=REFUSES),
    Edit("capacity raised", LIMIT,
         bounded("lengthen", "2", Call('{T}{"2x"}', heard="value={'2x'}")),
         bounded("lengthen", "4", Call('{T}{"four"}', LONGER, heard=None)), build="lock-range", diff=REFUSES),
    Edit("vector made a set", SET,
         collected("collect", "vector", Call("{T}{{1, 3}}", heard="value={[1,3]}"), Call("{T}{{3, 1, 3}}", OUTSIDE, heard=None)),
         collected("collect", "set", Call("{T}{{3, 1}}", heard="value={[1,3]}")), build="lock-range", diff=REFUSES),
    Edit("set made a vector", SET,
         collected("gather", "set", Call("{T}{{3, 1}}", heard="value={[1,3]}")),
         collected("gather", "vector", Call("{T}{{1, 3}}", heard="value={[1,3]}"), Call("{T}{{3, 1, 3}}", OUTSIDE, heard=None)),
         build="lock-range", diff=REFUSES),
    Edit("duration counted in fewer bits", LIMIT,
         ticks("std::int64_t", Call("{T}Ticks(100), {T}Ticks(100)", heard="a=100 b=100"),
               Call("{T}Ticks(300), {T}Ticks(100)", OUTSIDE, heard=None), Call("{T}Ticks(100), {T}Ticks(300)", OUTSIDE, heard=None)),
         ticks("std::int8_t", Call("{T}Ticks(100), {T}Ticks(100)", heard="a=100 b=100")), diff=NOTHING),
]


def one(signature, says="", heard="a=3", **more):
    return commands(Command(signature, says, (Call("3", heard=heard),), **more))


def flooded(signature, says=""):
    return commands(Command(signature, says, (Call("3", heard="a=3", flood="0"),)))


COMMANDS = [
    Edit("command added", "a command, also of a base", Side(),
         commands(Command("void added(std::int32_t a)",
                          calls=(Call("3", "the provider does not have this command", heard=None),))),
         build="lock-new"),
    Edit("command that tells since when", "a command, also of a base", Side(),
         commands(Command("void later(std::int32_t a)", "since(2)",
                          (Call("3", "the provider does not have this command", heard=None),))),
         build="lock-new"),
    Edit("command renamed with was", "a name, by `was()`",
         one("void before(std::int32_t a)"), one("void behind(std::int32_t a)", 'was("before")'), build="lock-renamed"),
    Edit("contract renamed with was", "a name, by `was()`", second_contract("Before"), second_contract("Behind", 'was("{T}Before")'), build="lock-renamed"),
    Edit("commands reordered", "the order of declarations",
         commands(Command("void first(std::int32_t a)", calls=(Call("1", heard="a=1"),)),
                  Command("void second(std::int32_t a)", calls=(Call("2", heard="a=2"),))),
         commands(Command("void second(std::int32_t a)", calls=(Call("4", heard="a=4"),)),
                  Command("void first(std::int32_t a)", calls=(Call("3", heard="a=3"),))),
         diff=NOTHING),
    Edit("parameter added", "a parameter, a value of an event",
         commands(Command("void grow(std::int32_t a)", calls=(Call("3", heard="a=3 b=0"),))),
         commands(Command("void grow(std::int32_t a, double b)", calls=(Call("3, 4.5", heard="a=3"),))), build="lock-new"),
    Edit("command documented", "a comment",
         one("void documented(std::int32_t a)"), one("void documented(std::int32_t a)", above="  /// Says a number.\n"),
         diff=NOTHING),
    Edit("command deprecated", "`deprecated()`",
         one("void deprecated_one(std::int32_t a)"), one("void deprecated_one(std::int32_t a)", 'deprecated("use b")'),
         build="lock-stale"),
    Edit("queue made longer", POLICY, flooded("void deep(std::int32_t a)", "queue(2)"),
         flooded("void deep(std::int32_t a)", "queue(9)"), build="lock-stale"),
    Edit("command made latest", POLICY, flooded("void newest(std::int32_t a)"),
         flooded("void newest(std::int32_t a)", "latest()"), build="lock-stale"),
    Edit("command no longer latest", POLICY, flooded("void all_of_them(std::int32_t a)", "latest()"),
         flooded("void all_of_them(std::int32_t a)"), build="lock-stale"),
    Edit("ttl changed", POLICY, one("void timely(std::int32_t a)", "ttl(5s)"),
         one("void timely(std::int32_t a)", "ttl(9s)"), build="lock-stale"),
    Edit("deadline changed", POLICY, one("void awaited(std::int32_t a)", "deadline(5s)"),
         one("void awaited(std::int32_t a)", "deadline(9s)"), build="lock-stale"),
]

EVENTS = [
    Edit("event added", "an event, also of a base", Side(), Side(events=(Event("added_event", "double", emits="7"),)),
         build="lock-new"),
    Edit("event renamed with was", "a name, by `was()`",
         Side(events=(Event("before_event", "double", emits="7", heard="8"),)),
         Side(events=(Event("behind_event", "double", 'was("before_event")', emits="8", heard="7"),)), build="lock-renamed"),
    Edit("values added to an event", "a parameter, a value of an event",
         Side(types=PART % ("", "Part", ""), events=(Event("grown_event", "double", emits="7", heard="8"),)),
         Side(types=PART % ("", "Part", ""),
              events=(Event("grown_event", "double, {T}Part, std::array<double, 2>, double", emits="8, {T}Part{9}, {}, 3",
                            heard="7 {1} [0,0] 0"),)),
         build="lock-new"),
    Edit("event made latched", POLICY,
         Side(events=(Event("kept_event", "double", emits="7", heard="8"),)),
         Side(events=(Event("kept_event", "double", "latched()", emits="8", heard="7"),)), build="lock-stale"),
    Edit("queue of an event changed", POLICY,
         Side(events=(Event("deep_event", "double", "queue(2)", emits="7", heard="8"),)),
         Side(events=(Event("deep_event", "double", "queue(9)", emits="8", heard="7"),)), build="lock-stale"),
    Edit("event made latest", POLICY,
         Side(events=(Event("newest_event", "double", emits="7", heard="8"),)),
         Side(events=(Event("newest_event", "double", "latest()", emits="8", heard="7"),)), build="lock-stale"),
]

# A member that a base gets stands before what the heir has, in the heir too, and does not move that on the wire.
INHERITED = [
    Edit("command added to a base", "a command, also of a base", Side(),
         commands(Command("void inherited(std::int32_t a)",
                          calls=(Call("3", "the provider does not have this command", heard=None),))),
         build="lock-new", inherited=True),
    Edit("read added to a base", "a command, also of a base", Side(),
         commands(Command("double measured() const", gives="7")), build="lock-new", inherited=True),
    Edit("event added to a base", "an event, also of a base", Side(),
         Side(events=(Event("inherited_event", "double", "latched()", emits="7"),)), build="lock-new", inherited=True),
    Edit("commands of a base reordered", "the order of declarations",
         commands(Command("void left(std::int32_t a)", calls=(Call("1", heard="a=1"),)),
                  Command("void right(std::int32_t a)", calls=(Call("2", heard="a=2"),))),
         commands(Command("void right(std::int32_t a)", calls=(Call("4", heard="a=4"),)),
                  Command("void left(std::int32_t a)", calls=(Call("3", heard="a=3"),))),
         diff=NOTHING, inherited=True),
]

COMPATIBLE = FIELDS + MOVES + ENUMERATORS + LIMITS + COMMANDS + EVENTS + INHERITED
