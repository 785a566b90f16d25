"""Draws random annotated C++ types: the header's text, and how a test fills and compares their values."""

import random

INTEGERS = ["std::int8_t", "std::int16_t", "std::int32_t", "std::int64_t",
            "std::uint8_t", "std::uint16_t", "std::uint32_t", "std::uint64_t"]
NUMBERS = INTEGERS + ["float", "double"]
KEYS = [*INTEGERS, "std::string"]
EIGEN = ["Eigen::Vector2d", "Eigen::Vector3d", "Eigen::Vector4d", "Eigen::Matrix3d", "Eigen::Matrix4d",
         "Eigen::Vector3f", "Eigen::Matrix<double, 2, 5>", "Eigen::Matrix<double, 6, 1>", "Eigen::Matrix<float, 6, 6>",
         "Eigen::Affine3d"]
OPEN_EIGEN = {"Eigen::VectorXd": 1, "Eigen::MatrixXd": 2, "Eigen::Matrix<double, 3, Eigen::Dynamic>": 1,
              "Eigen::Matrix<std::int32_t, Eigen::Dynamic, 1>": 1}
CHRONO = ["std::chrono::nanoseconds", "std::chrono::milliseconds", "std::chrono::seconds",
          "std::chrono::duration<double>", "std::chrono::duration<float, std::milli>", "suture::Time",
          "std::chrono::system_clock::time_point"]


STANDARD = ["array", "chrono", "deque", "map", "memory", "optional", "set", "string", "tuple", "unordered_map", "unordered_set",
            "variant", "vector"]
# The words of a header that need an include whose name is another one.
NEEDED = {"std::byte": "<cstddef>", "int8_t": "<cstdint>", "int16_t": "<cstdint>", "int32_t": "<cstdint>", "int64_t": "<cstdint>",
          "std::unique_ptr": "<memory>", "std::pair": "<utility>", "std::monostate": "<variant>", "Eigen::": "<Eigen/Geometry>",
          "suture::Time": "<suture/base/time.h>", **{f"std::{name}": f"<{name}>" for name in STANDARD}}

OPEN = 1 << 16  # of a level: its values have so many elements, but no capacity() says so


def declared_values(name):
    """Returns the lines that declare what fills and compares a struct."""
    return [f"inline void fill({name}& value, Random& random);",
            f"inline bool same(const {name}& a, const {name}& b);",
            f"inline void fill({name}& value, Random& random, Bounds&) {{ fill(value, random); }}",
            f"inline bool equal(const {name}& a, const {name}& b, Tag) {{ return same(a, b); }}"]


def defined_values(name, fields, bases=()):
    """Returns the lines that define it, the bases first."""
    lines = ["", f"inline void fill([[maybe_unused]] {name}& value, [[maybe_unused]] Random& random) {{",
             *(f"  fill(static_cast<{base}&>(value), random);" for base in bases)]
    for field in fields:
        lines.append(f"  constexpr unsigned limits_{field.name}[] = {{{', '.join(map(str, [*field.bounds, 0]))}}};")
        lines.append(f"  Bounds bounds_{field.name} = limits_{field.name};")
        deeper = f"if (const Descent deeper(random); deeper.goesOn()) " if field.leads_back else ""
        lines.append(f"  {deeper}fill(value.{field.name}, random, bounds_{field.name});")
        if field.range:
            lines.append(f"  if (random.finite) keepWithin(value.{field.name}, {field.range[0]}, {field.range[1]});")
    return [*lines, "}", f"inline bool same([[maybe_unused]] const {name}& a, [[maybe_unused]] const {name}& b) {{", "  return true",
            *(f"      && same(static_cast<const {base}&>(a), static_cast<const {base}&>(b))" for base in bases),
            *(f"      && equal(a.{field.name}, b.{field.name}, Tag())" for field in fields), "  ;", "}"]


LEVELS = ["std::vector", "std::deque", "std::set", "std::unordered_set", "std::map", "std::unordered_map", "std::string"]


def parts_of(type_):
    """Returns the template and what stands between its brackets; of a matrix or a duration nothing, since these are wholes."""
    template, _, rest = type_.partition("<")
    if not rest or not template.startswith("std::") or template.startswith("std::chrono"):
        return template, []
    parts, depth = [""], 0
    for letter in rest[:-1]:
        depth += (letter == "<") - (letter == ">")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return template, [part.strip() for part in parts]


def own_levels(type_, template):
    return OPEN_EIGEN.get(type_, 1 if template in LEVELS else 0)


def levels_of(type_):
    template, parts = parts_of(type_)
    return own_levels(type_, template) + sum(levels_of(part) for part in parts)


def includes(text):
    """Returns the lines with which a header of this text begins."""
    found = sorted({file for word, file in NEEDED.items() if word in text})
    return ["#pragma once", "#include <suture/annotate.h>", *(f"#include {file}" for file in found)]


class Field:
    """This is one member: its declaration, and the bounds of its levels, which its annotation states unless they are OPEN."""

    def __init__(self, name, type_, bounds=(), owns_heap=False):
        self.name, self.type, self.bounds, self.owns_heap = name, type_, bounds, owns_heap
        self.extent = ""  # of a plain array
        self.notes = ()  # what the annotation says beside the bounds
        self.range = None
        self.leads_back = False  # to the struct that has it

    def declaration(self):
        return f"  {self.annotated()}{self.plain_declaration()}"

    def annotated(self):
        """Returns what stands before a declaration."""
        return f"SUTURE_FIELD({self.annotation()}) " if self.annotation() else ""

    def parameter(self, name):
        return f"{self.annotated()}const {self.type}& {name}"

    def plain_declaration(self):
        return f"{self.type} {self.name}{self.extent}{{}};"

    def inside(self):
        """Returns the members that have a part of this type only, each with the bounds of that part."""
        template, parts = parts_of(self.type)
        bounds = self.bounds[own_levels(self.type, template):]
        found = []
        for part in parts:
            levels = levels_of(part)
            if part not in ("std::monostate", "std::byte") and not part.isdigit():
                found.append(Field(self.name, part, bounds[:levels], self.owns_heap))
            bounds = bounds[levels:]
        return found

    def annotation(self):
        stated = [0 if bound & OPEN else bound for bound in self.bounds]
        ranges = [f"range({self.range[0]}, {self.range[1]})"] if self.range else []
        return ", ".join([f"capacity({', '.join(map(str, stated))})"] * any(stated) + ranges + list(self.notes))


class Types:
    """This is a set of enums and structs; a later struct may hold an earlier one."""

    pointers = False  # a std::unique_ptr is nothing that an event or an answer could copy

    def __init__(self, seed, count=5):
        self.random = random.Random(seed)
        self.open = seed % 2 == 1  # some levels have no bounds, and only devices provide them
        self.enums = {f"Choice{i}": ["First", "Second = 70", "Third"] for i in range(2)}
        self.optional = False
        self.structs = {}
        for i in range(count):
            self.structs[f"Record{i}"] = [self.field(f"member_{j}") for j in range(self.random.randint(2, 7))]

    def owns_heap(self, struct):
        return any(field.owns_heap for field in self.structs[struct])

    def simple(self):
        kind = self.random.randrange(5)
        if kind == 0:
            return "bool"
        if kind == 1:
            return self.random.choice(list(self.enums))
        if kind == 2:
            return self.random.choice(EIGEN + ["Eigen::Quaterniond", "Eigen::Isometry3d"])
        if kind == 3:
            return self.random.choice(CHRONO)
        return self.random.choice(NUMBERS)

    def leaf(self):
        """Returns what nested() does, of a type that holds no other."""
        return self.simple(), [], False

    def nested(self, depth):
        """Returns a type, its bounds from outside to inside, and True if it owns heap."""
        kind = self.random.randrange(9 if depth > 0 else 2)
        if kind == 0:
            return "std::string", [self.random.randint(1, 9)], True
        if kind == 1:
            return self.leaf()
        if kind == 2:
            name = self.random.choice(list(OPEN_EIGEN))
            return name, [self.random.randint(1, 4) for _ in range(OPEN_EIGEN[name])], True
        if kind == 3:
            key = self.random.choice(KEYS)
            bounds = [self.random.randint(1, 3)] + ([self.random.randint(1, 9)] if key == "std::string" else [])
            if self.random.randrange(2):
                return f"{self.random.choice(['std::set', 'std::unordered_set'])}<{key}>", bounds, True
            value, inner, _ = self.nested(depth - 1)
            container = self.random.choice(["std::map", "std::unordered_map"])
            return f"{container}<{key}, {value}>", bounds + inner, True
        if kind == 4:
            count = self.random.randint(2, 4)
            parts = [self.nested(depth - 1) for _ in range(count)]
            name = self.random.choice(["std::tuple", "std::variant"] + ["std::pair"] * (count == 2))
            types = [part[0] for part in parts]
            if name == "std::variant" and self.random.randrange(2):
                types[0], parts[0] = "std::monostate", ("", [], False)
            return (f"{name}<{', '.join(types)}>", [bound for part in parts for bound in part[1]],
                    any(part[2] for part in parts))
        element, inner, owns = self.nested(depth - 1)
        if kind == 5:
            pointer = self.pointers and self.random.randrange(3) == 0
            return f"{'std::unique_ptr' if pointer else 'std::optional'}<{element}>", inner, owns or pointer
        if kind == 6:
            return f"std::array<{element}, {self.random.randint(1, 3)}>", inner, owns
        container = self.random.choice(["std::vector", "std::deque"])
        element = self.random.choice([element, element, "std::byte"])
        bounds = [] if element == "std::byte" else inner
        return f"{container}<{element}>", [self.random.randint(1, 3), *bounds], True

    def some_open(self, bounds):
        return [bound | OPEN if self.open and self.random.randrange(4) == 0 else bound for bound in bounds]

    def field(self, name):
        if self.random.randrange(2):
            while True:
                type_, bounds, owns = self.nested(3)
                if len(bounds) <= 8:
                    return Field(name, type_, tuple(self.some_open(bounds)), owns)
        kind = self.random.randrange(6)
        if kind == 0:
            return Field(name, "std::string", tuple(self.some_open([self.random.randint(1, 40)])), True)
        if kind == 1:
            return Field(name, f"std::array<{self.random.choice(NUMBERS)}, {self.random.randint(1, 9)}>")
        if kind == 2:
            element = self.random.choice(["std::string", *NUMBERS, *self.structs])
            bounds = (self.random.randint(1, 6),) + ((self.random.randint(1, 20),) if element == "std::string" else ())
            return Field(name, f"std::vector<{element}>", bounds, True)
        if kind == 3 and self.structs:
            struct = self.random.choice(list(self.structs))
            return Field(name, struct, (), self.owns_heap(struct))
        return Field(name, self.simple())

    def header(self):
        lines = ["namespace invented {", ""]
        for name, enumerators in self.enums.items():
            lines += [f"enum class SUTURE_TYPE() {name} : std::uint16_t {{ {', '.join(enumerators)} }};", ""]
        for name, fields in self.structs.items():
            lines += [f"struct SUTURE_TYPE() {name} {{", *(field.declaration() for field in fields), "};", ""]
        text = "\n".join(lines + self.interface() + ["}  // namespace invented", ""])
        return "\n".join([*includes(text), "", text])

    def interface(self):
        lines = ["class SUTURE_INTERFACE() Invented {", " public:", "  virtual ~Invented() = default;"]
        for name in self.structs:
            result = f"const {name}&" if self.owns_heap(name) else name
            lines += [f"  SUTURE_COMMAND() virtual void put_{name}(const {name}& value) = 0;",
                      f"  SUTURE_COMMAND() virtual {result} get_{name}() const = 0;",
                      f"  SUTURE_COMMAND() virtual {name} echo_{name}(const {name}& value) const = 0;",
                      f"  SUTURE_COMMAND() virtual {name} swap_{name}(std::int32_t number, const {name}& value, "
                      "Choice0 choice) = 0;",
                      f"  SUTURE_EVENT() suture::EventOf<{name}> got_{name};",
                      f"  SUTURE_EVENT() suture::EventOf<std::int32_t, {name}, Choice0> swapped_{name};"]
        lines += ["  SUTURE_COMMAND() virtual std::uint32_t swaps() = 0;",
                  "  SUTURE_COMMAND() virtual void finish() = 0;", "  SUTURE_EVENT() suture::EventOf<> finished;"]
        if self.optional:
            lines += ["  SUTURE_COMMAND(optional()) virtual std::uint32_t later() { return 1; }",
                      "  SUTURE_COMMAND(optional()) virtual void later_void() {}",
                      "  SUTURE_COMMAND(optional()) virtual double later_read() const { return 2; }"]
        return [*lines, "};", ""]

    def values(self):
        """Returns C++ that fills and compares the structs, on top of values.h."""
        lines = ['#pragma once', '#include "values.h"', '#include "invented.h"', "", "namespace invented {", ""]
        lines += [line for name in self.structs for line in declared_values(name)]
        lines += [line for name, fields in self.structs.items() for line in defined_values(name, fields)]
        return "\n".join(lines + ["", "}  // namespace invented", ""])

    def program(self):
        server = "public suture::Device" if self.open else "public suture::EventTask"
        return PROGRAM.replace("@SERVER@", server).replace("@RUN@", "" if self.open else "  void run() override {}") \
                      .replace("@OVERRIDES@", "\n".join(self.override(name) for name in self.structs)) \
                      .replace("@STORED@", "\n".join(f"  {name} {name}_;" for name in self.structs)) \
                      .replace("@SUBSCRIBE@", "\n".join(
                          f"    arm.on().got_{name}([this](const {name}& value) {{ {name}_ = value; ++events; }});\n"
                          f"    arm.on().swapped_{name}([this](const std::int32_t& n, const {name}& value, "
                          f"const Choice0& c) {{ {name}_ = value; number = n; choice = c; ++events; }});"
                          for name in self.structs)) \
                      .replace("@OPTIONAL@", OPTIONAL if self.optional else "") \
                      .replace("@CHECKS@", "\n".join(f"    CHECK_ALL({name})" for name in self.structs))

    def override(self, name):
        result = f"const {name}&" if self.owns_heap(name) else name
        return (f"  void put_{name}(const {name}& value) override {{ {name}_ = value; "
                f"if (!port_.emit().got_{name}(value)) std::abort(); }}\n"
                f"  {result} get_{name}() const override {{ return {name}_; }}\n"
                f"  {name} echo_{name}(const {name}& value) const override {{ return value; }}\n"
                f"  {name} swap_{name}(std::int32_t number, const {name}& value, Choice0 choice) override {{\n"
                f"    ++swaps_;\n"
                f"    if (!port_.emit().swapped_{name}(number, value, choice)) std::abort();\n"
                f"    return std::exchange({name}_, value);\n  }}")


# A client that knows optional commands finds this at a provider of its own age, and at an older one.
OPTIONAL = r'''
  const auto later = client.arm.later.start().within(10s);
  const auto later_void = client.arm.later_void();
  const auto later_read = client.arm.later_read.fresh().within(10s);
  if (older) {
    CHECK(!later && later.error() == suture::Errc::NotImplemented);
    CHECK(!later_void && later_void.error() == suture::Errc::NotImplemented);
    CHECK(!later_read && later_read.error() == suture::Errc::NotImplemented);
    CHECK(client.arm.later_read().error() == suture::Errc::NotImplemented);
  } else {
    CHECK(later && *later == 1);
    CHECK(later_void);
    CHECK(later_read && *later_read == 2);
  }
'''

PROGRAM = r'''
#include <suture/component/device.h>
#include <suture/component/task/event_task.h>
#include <suture/manager/manager.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "invented.suture.h"
#include "invented_values.h"

namespace invented {

using namespace std::chrono_literals;

class Server final : @SERVER@, public Invented {
 public:
@OVERRIDES@
  std::uint32_t swaps() override { return swaps_; }
  void finish() override { port_.emit().finished(); }

 private:
@RUN@
@STORED@
  std::uint32_t swaps_ = 0;
  suture::Provided<Invented> port_{*this, "Invented", *this};
};

struct Client final : suture::Device {
  Client() {
@SUBSCRIBE@
    arm.on().finished([this] { finished = true; });
  }
  suture::Required<Invented> arm{*this, "Invented"};
@STORED@
  int events = 0;
  std::int32_t number = 0;
  Choice0 choice{};
  bool finished = false;
};

#define CHECK(condition)                                             \
  do {                                                               \
    if (!(condition)) {                                              \
      std::fprintf(stderr, "round %d: %s\n", round, #condition);     \
      return 1;                                                      \
    }                                                                \
  } while (false)

#define CHECK_ALL(T)                                                  \
  {                                                                   \
    T value;                                                          \
    fill(value, random);                                              \
    const auto echoed = client.arm.echo_##T.start(value).within(10s); \
    CHECK(echoed && same(*echoed, value));                            \
    const int before = client.events;                                 \
    CHECK(client.arm.put_##T(value));                                 \
    const auto until = suture::now() + 10s;                           \
    while (client.events == before && suture::now() < until) client.waitForEvents(until); \
    CHECK(client.events == before + 1 && same(client.T##_, value));   \
    const auto fresh = client.arm.get_##T.fresh().within(10s);        \
    CHECK(fresh && same(*fresh, value));                              \
    T other;                                                          \
    fill(other, random);                                              \
    const auto old = client.arm.swap_##T.start(round, other, Choice0::Third).within(10s); \
    CHECK(old && same(*old, value));                                  \
    while (client.events == before + 1 && suture::now() < until) client.waitForEvents(until); \
    CHECK(client.events == before + 2 && same(client.T##_, other));   \
    CHECK(client.number == round && client.choice == Choice0::Third); \
  }

int call(Client& client, unsigned seed, [[maybe_unused]] bool older) {
  Random random(seed);
  for (int round = 0; round < 20; ++round) {
@CHECKS@
  }
  const int round = -1;
  CHECK(*client.arm.swaps.start().within(10s) >= 20);
@OPTIONAL@
  CHECK(client.arm.finish.start().within(10s));
  const auto until = suture::now() + 10s;
  while (!client.finished && suture::now() < until) client.waitForEvents(until);
  CHECK(client.finished);
  std::printf("all values came back, process %d\n", getpid());
  return 0;
}

}  // namespace invented

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::string address = argv[2];
  if (std::strcmp(argv[1], "serve") == 0) {
    sigset_t end;
    sigemptyset(&end);
    sigaddset(&end, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &end, nullptr);
    invented::Server server;
    suture::Manager manager("server", address);
    manager.add("Server", server);
    manager.start();
    int received = 0;
    sigwait(&end, &received);
    manager.stop();
    return 0;
  }
  invented::Client client;
  suture::Manager manager("client", address);
  manager.add("Client", client);
  manager.start();
  manager.connect("Client/Invented", "server:Server/Invented");
  const int status = invented::call(client, static_cast<unsigned>(std::atoi(argv[3])),
                                    std::strcmp(argv[1], "call-older") == 0);
  manager.stop();
  return status;
}
'''
