"""Draws one random header: types from the whole mapping table (docs/types.md), a contract, and names that Cap'n Proto, its
C++ and generated code have a use for. It can be made smaller, piece by piece, for who looks for the fault in it."""

import copy
import re

import random_names
from random_types import (CHRONO, NUMBERS, OPEN, OPEN_EIGEN, Field, Types, parts_of, declared_values, defined_values, includes)

# What only structs that cannot be edited may have.
FOREIGN = ["char", "long long", "unsigned long long", "std::array<char, 5>", "std::optional<long long>"]
# Where a struct stands, {0} being its name, {1} the seed: at home, in another namespace, in a class, or in a header that cannot be edited.
PLACES = ["{0}", "{0}", "elsewhere{1}::{0}", "Nest{0}::{0}", "vendor{1}::{0}"]
# What bulk() takes: columns of fixed length are a list of vectors, not of numbers.
BULK_EIGEN = {name: bounds for name, bounds in OPEN_EIGEN.items() if not name.startswith("Eigen::Matrix<double, 3")}
UNITS = ["m", "rad", "m/s", "N.m", "kg.m2/s"]
LARGE_EIGEN = ["Eigen::Matrix<double, 6, 6>", "Eigen::Matrix<float, 3, 7>"]
WAITS = ["", "", "queue(8)", "latest()", "ttl(20ms)", "queue(4), ttl(1s)", "direct()"]


class Enum:
    """This is one enum, perhaps one that cannot be edited: how it is declared, and its enumerators; values.h takes the first, `Second` and `Third`."""

    def __init__(self, head, enumerators):
        self.head, self.enumerators = head, enumerators


class Command:
    """This is a command or an event of a contract, and the types that it names."""

    def __init__(self, text, types):
        self.text, self.types = text, types


class Header(Types):
    """A header has the name of its seed, and so have its namespaces: any number of headers fit in one program."""

    pointers = True

    def __init__(self, seed):
        super().__init__(seed, 0)
        self.seed, self.name = seed, f"h{seed}"
        self.open = True
        self.bases = {}
        self.templates = set()
        self.contract = None
        self.commands = []
        self.namesakes = []  # functions of the namespace that are called as commands are
        *names, contract = self.random.sample(list(random_names.TYPES), 6)
        self.enums = dict(self.enum(name) for name in [names[0], "Choice"][:self.random.randint(1, 2)])
        for name in names[1:self.random.randint(2, 5)]:
            self.draw_struct(self.random.choice(PLACES).format(name, seed))
        if self.random.randrange(4) == 0:
            self.contract = contract
            self.commands = self.draw_commands()

    def enum(self, name):
        """Returns the path and the enum itself, which stands at home or in a class."""
        more = self.random.sample(random_names.ENUMERATORS, self.random.randint(0, 4))
        last = self.random.choice(["Third", "Third", "Third SUTURE_FIELD(fallback())"])
        enumerators = ["First", *more[:2], "Second = 70", *more[2:], last]
        if name.startswith("Choice") and self.random.randrange(2) == 0:  # the first type says where generated names are: at home
            enumerators[-1] = "Third"
            base = self.random.choice(["", " : char", " : long long", " : unsigned long long", " : std::uint8_t"])
            return f"vendor{self.seed}::{name}", Enum(f"{self.random.choice(['enum', 'enum class'])} {name}{base}", enumerators)
        nested = self.random.randrange(3) == 0
        head = "enum" if nested and self.random.randrange(2) else "enum class"
        base = self.random.choice(["", " : std::uint8_t", " : std::uint16_t", " : std::int32_t", " : std::int64_t"])
        path = f"Nest{name}::{name}" if nested else name
        return path, Enum(f"{head} SUTURE_TYPE() {name}{base}", enumerators)

    def draw_struct(self, path):
        members = self.random.sample(random_names.MEMBERS, self.random.randint(1, 3))
        if path in random_names.TYPES and self.random.randrange(6) == 0:
            self.templates.add(path)
            types = [self.random.choice([self.simple(), *self.structs]), "std::int32_t"]
            self.structs[path] = [Field(*field) for field in zip(members, types)]
            return
        if self.random.randrange(2):
            self.bases[path] = self.draw_bases()
        fields = [self.special_field(name) if self.random.randrange(5) == 0 else self.field(name) for name in members]
        if path.startswith("vendor"):
            for field in fields:
                field.extent = ""  # all() means them as they are
            fields += [Field("letters", "std::vector<char>", (3,), True), Field("kept", self.random.choice(FOREIGN))]
        elif self.random.randrange(6) == 0:
            fields.append(self.field_that_leads_back(path))
        self.structs[path] = fields

    def field_that_leads_back(self, path):
        struct = path.rpartition("::")[2]
        type_, bounds = self.random.choice([(f"std::unique_ptr<{struct}>", ()), (f"std::vector<{struct}>", (OPEN | 2,)),
                                            (f"std::map<std::int8_t, {struct}>", (OPEN | 2,))])
        field = Field("next", type_, bounds, True)
        field.leads_back = True
        return field

    def draw_bases(self):
        """Returns up to three structs, no two of which have a base in common: that would be there twice."""
        bases, taken = [], set()
        for base in self.random.sample(list(self.structs), len(self.structs)):
            if self.random.randrange(2) and not taken & self.ancestry(base):
                bases.append(base)
                taken |= self.ancestry(base)
        return bases[:3]

    def ancestry(self, path):
        """Returns the struct and all that it derives from."""
        return {path}.union(*(self.ancestry(base) for base in self.bases.get(path, [])))

    def leaf(self):
        structs = list(self.structs)
        if structs and self.random.randrange(3) == 0:
            struct = self.random.choice(structs)
            return struct, [], self.owns(struct)
        return super().leaf()

    def field(self, name):
        """Returns a member whose numbers may have a range and a unit."""
        field = super().field(name)
        template, parts = parts_of(field.type)
        number = parts[0] if template in ("std::array", "std::vector", "std::deque", "std::optional") and parts else field.type
        if number in NUMBERS and self.random.randrange(2) and "optional" not in template:
            signed = not number.startswith("std::uint")
            field.range = self.random.choice([(0, 100), (-100 if signed else 0, 7), (0, 0), (-0.5 if signed else 0, 6.5)])
        if number in NUMBERS and self.random.randrange(3) == 0:
            field.notes = (f'unit("{self.random.choice(UNITS)}")',)
        return field

    def special_field(self, name):
        """Returns a member such as no other draw gives."""
        kind = self.random.randrange(6)
        if kind == 0:
            field = Field(name, self.random.choice([*NUMBERS, *CHRONO, *self.enums, *self.enums]))
            field.extent = f"[{self.random.randint(1, 4)}]"
        elif kind == 1:
            field = Field(name, self.random.choice(["const void*", "std::unique_ptr<int>"]))
            field.notes = ("skip()",)
        elif kind == 2:
            type_, bounds = self.random.choice([(f"std::vector<{self.random.choice(NUMBERS)}>", 1),
                                                (f"std::array<{self.random.choice(NUMBERS)}, 7>", 0),
                                                *BULK_EIGEN.items(), *((matrix, 0) for matrix in LARGE_EIGEN)])
            field = Field(name, type_, tuple(self.some_open([self.random.randint(1, 4) for _ in range(bounds)])), bounds > 0)
            field.notes = ("bulk()",)
        elif kind == 3:
            field = Field(name, self.random.choice(["float", "double"]))
            field.notes = (f'unit("{self.random.choice(UNITS)}")',)
        elif kind == 4:
            key = self.random.choice(list(self.enums))
            type_ = self.random.choice(["std::set<{0}>", "std::unordered_set<{0}>", "std::map<{0}, bool>",
                                        "std::unordered_map<{0}, std::int8_t>"]).format(key)
            field = Field(name, type_, (self.random.randint(1, 2),), True)
        else:
            field = Field(name, self.random.choice(list(self.enums)))
            field.notes = ("since(3)",)
        return field

    def draw_commands(self):
        names = self.random.sample(random_names.COMMANDS, self.random.randint(1, 3))
        self.namesakes = [name for name in names if self.random.randrange(3) == 0 and name != "isValid"]
        return [self.command(name) for name in names]

    def payload(self):
        """Returns what a parameter, a result or an event's value may be: a struct, or any other type, annotated as a member is."""
        structs = [name for name in self.structs if self.is_copyable(name)]
        if structs and self.random.randrange(2):
            struct = self.random.choice(structs)
            return Field("", struct, (), self.owns(struct))
        while True:
            field = self.field("")
            if "unique_ptr" not in field.type and not any(names(field.type, struct) for struct in self.structs):
                return field

    def command(self, name):
        kind = self.random.randrange(5)
        value, other = self.payload(), self.payload()
        parameter = self.random.choice([word for word in random_names.MEMBERS if word != name])
        if kind == 0:
            how = self.random.choice(WAITS)
            return Command(f"SUTURE_COMMAND({how}) virtual void {name}({value.parameter(parameter)}) = 0;", [value.type])
        if kind == 1:
            result = f"const {value.type}&" if value.owns_heap else value.type
            return Command(f"SUTURE_COMMAND() {value.annotated()}virtual {result} {name}() const = 0;", [value.type])
        if kind == 2:
            how, const = self.random.choice([("", " const"), ("concurrent()", " const"), ("", ""), ("deadline(2s)", "")])
            return Command(f"SUTURE_COMMAND({how}) {value.annotated()}virtual {value.type} {name}({other.parameter(parameter)}){const} = 0;",
                           [value.type, other.type])
        if kind == 3:
            return Command(f"SUTURE_COMMAND() virtual void {name}() = 0;", [])
        values = self.random.choice([[], [value], [value, other]])
        stated = "".join(f"SUTURE_FIELD({field.annotation()}) " for field in values)
        return Command(f"SUTURE_EVENT({self.random.choice(['', 'latched()', 'queue(4)'])}) {stated}"
                       f"suture::EventOf<{', '.join(field.type for field in values)}> {name};", [field.type for field in values])

    def owns(self, type_):
        return type_ == "std::string" or type_ in self.structs and any(
            field.owns_heap for field in self.structs[type_]) or any(self.owns(base) for base in self.bases.get(type_, []))

    owns_heap = owns

    def is_copyable(self, struct):
        """Tells if events and answers can copy it: nothing in it is a std::unique_ptr."""
        fields = self.structs[struct]
        return not any("unique_ptr" in field.type for field in fields) and all(
            self.is_copyable(other) for other in self.structs
            if other != struct and (other in self.bases.get(struct, []) or any(names(field.type, other) for field in fields)))

    # The text.

    def header(self):
        lines = [f"namespace {self.name} {{", ""]
        for path, enum in self.enums.items():
            lines += self.placed(path, [f"{enum.head} {{ {', '.join(enum.enumerators)} }};"])
            lines += [f"SUTURE_EXTERNAL_TYPE({path});", ""] if path.startswith("vendor") else [""]
        for path in self.structs:
            lines += self.struct(path)
        if self.contract:
            lines += [f"inline double {name}(double value) {{ return value; }}" for name in self.namesakes]
            lines += [f"class SUTURE_INTERFACE() {self.contract} {{", " public:", f"  virtual ~{self.contract}() = default;",
                      *(f"  {command.text}" for command in self.commands), "};", ""]
        text = "\n".join([*lines, f"}}  // namespace {self.name}", ""])
        return "\n".join([*includes(text), "", text])

    def placed(self, path, lines):
        """Returns the lines of a type where it stands."""
        place = path.rpartition("::")[0]
        if place.startswith("Nest"):
            return [f"struct {place} {{", *lines, "};"]
        if place:
            return [f"}}  // namespace {self.name}", f"namespace {place} {{", f"using namespace {self.name};", *lines, "}",
                    f"namespace {self.name} {{"]
        return lines

    def struct(self, path):
        place, _, name = path.rpartition("::")
        fields, base = self.structs[path], " : " * bool(self.bases.get(path)) + ", ".join(self.bases.get(path, []))
        if path in self.templates:
            first, *others = fields
            return ["template <class T>", f"struct SUTURE_TYPE() {name}Of {{", f"  T {first.name}{{}};",
                    *(field.declaration() for field in others), "};", f"using {name} = {name}Of<{first.type}>;", ""]
        if not place.startswith("vendor"):
            lines = [f"struct SUTURE_TYPE() {name}{base} {{", *(field.declaration() for field in fields), "};"]
            return [*self.placed(path, lines), ""]
        lines = [f"struct {name}{base} {{", *("  " + field.plain_declaration() for field in fields), "};"]
        stated = [f"member({field.name}, {field.annotation()})" for field in fields if field.annotation()]
        return [*self.placed(path, lines), f"SUTURE_EXTERNAL_TYPE({path}, {', '.join(['all()', *stated])});", ""]

    def qualified(self, path):
        return f"::{path}" if is_away(path) else f"::{self.name}::{path}"

    @staticmethod
    def wire(struct):
        """Its name there. That of what stands in a class begins with the class, so that Cap'n Proto does not need it."""
        place, _, name = struct.rpartition("::")
        return place + name if place.startswith("Nest") else random_names.TYPES[name]

    def slot(self, path):
        return f"::{self.name}::{path.replace('::', '')}Slot"

    def values(self):
        """Returns C++ that fills and compares the structs, on top of values.h."""
        lines = ["namespace invented {", ""]
        lines += [line for path in self.structs for line in declared_values(self.qualified(path))]
        for path, fields in self.structs.items():
            taken = [field for field in fields if "skip()" not in field.notes]
            bases = [self.qualified(base) for base in self.bases.get(path, [])]
            lines += defined_values(self.qualified(path), taken, bases)
        return "\n".join([*lines, "", "}  // namespace invented", ""])

    def conversions(self):
        """Returns the declarations of what converts and judges slots, which the generated header has no need to declare."""
        lines = [f"void toWire(const {self.slot(path)}&, ::{self.name}::wire::{self.wire(path)}::Builder);\n"
                 f"suture::Errc fromWire(::{self.name}::wire::{self.wire(path)}::Reader, {self.slot(path)}&, suture::Duration);\n"
                 f"bool isValid(const {self.slot(path)}&, suture::FieldPath* = nullptr);" for path in self.structs]
        return "\n".join([f"namespace {self.name} {{", *lines, "}", ""])

    def checks(self):
        """Returns a function that takes values through each struct; each member with a bound gets one element too many once."""
        lines = [f"static void check_{self.name}([[maybe_unused]] Random& random) {{"]
        for path, fields in self.structs.items():
            value = self.qualified(path)
            lines += ["  {", f'    RoundTrip<{value}, {self.slot(path)}, ::{self.name}::wire::{self.wire(path)}> trip("{value}");',
                      f"    checkAll(trip, random, {value}());"]
            for field in fields:
                if field.bounds:
                    lines += [f"    trip.checkBeyond(random, []({value}& value, Random& source) {{",
                              f"      constexpr unsigned all[] = {{{', '.join(map(str, field.bounds))}}};",
                              "      Bounds bounds = all;", f"      fill(value.{field.name}, source, bounds);", "    });"]
                if field.range and field.type in NUMBERS:
                    beyond = int(field.range[1]) + 1
                    lines += [f"    trip.checkOutside([]({value}& value) {{ value.{field.name} = {beyond}; }});"]
            lines += ["  }"]
        return "\n".join([*lines, "}", ""])

    # What is smaller.

    def smaller(self):
        """Yields headers that lack a piece of this one, the largest pieces first."""
        first = next(iter([*self.enums, *self.structs]), "")
        if self.contract and not is_away(first):
            yield self.without(lambda copied: copied.drop_contract())
        for path in filter(self.is_needless, [*self.structs, *self.enums]):
            yield self.without(lambda copied, path=path: copied.drop_type(path))
        for path, bases in self.bases.items():
            for base in bases:
                yield self.without(lambda copied, path=path, base=base: copied.bases[path].remove(base))
        for i in range(len(self.commands)):
            yield self.without(lambda copied, i=i: copied.commands.pop(i))
        for path, fields in self.structs.items():
            for i, field in enumerate(fields):
                if i > 0 or path not in self.templates:  # the first of a template has the type of its parameter
                    yield self.without(lambda copied, path=path, i=i: copied.structs[path].pop(i))
                for inner in field.inside():
                    yield self.without(lambda copied, path=path, i=i, inner=inner: copied.structs[path].__setitem__(i, inner))
                if field.range:
                    yield self.without(lambda copied, path=path, i=i: setattr(copied.structs[path][i], "range", None))
        for path, enum in self.enums.items():
            for word in enum.enumerators:
                if word.split()[0] not in ("First", "Second", "Third"):
                    yield self.without(lambda copied, path=path, word=word: copied.enums[path].enumerators.remove(word))

    def is_needless(self, path):
        """Tells if the generated names stay where they are without this type: at home, if the first that is left stands there."""
        left = [other for other in [*self.enums, *self.structs] if other != path]
        return self.contract is not None or not left or not is_away(left[0])

    def without(self, drop):
        copied = copy.deepcopy(self)
        drop(copied)
        return copied

    def drop_contract(self):
        self.contract, self.commands, self.namesakes = None, [], []

    def drop_type(self, gone):
        """Drops it and what names it."""
        self.structs.pop(gone, None)
        self.enums.pop(gone, None)
        self.bases = {path: [base for base in bases if base != gone] for path, bases in self.bases.items() if path != gone}
        self.commands = [command for command in self.commands if not any(names(type_, gone) for type_ in command.types)]
        for path in [path for path in self.templates & self.structs.keys() if names(self.structs[path][0].type, gone)]:
            self.drop_type(path)
        for path, fields in self.structs.items():
            self.structs[path] = [field for field in fields if not names(field.type, gone)]


def is_away(path):
    """Tells if a type stands in another namespace than its header's."""
    return path.startswith(("elsewhere", "vendor"))


def names(type_, path):
    return re.search(rf"(?<![\w:]){re.escape(path)}(?![\w:])", type_) is not None

