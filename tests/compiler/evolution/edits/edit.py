"""Says what a row of the table says: an edit of a contract, each tool's verdict on it, and what two processes make of it."""

import dataclasses
import re

# Each verdict is the worst line of `suturec diff`.
NOTHING, FINE, REFUSES, BREAKS = "nothing", "fine", "refuses", "breaks"

ANNOTATION = re.compile(r"SUTURE_FIELD\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\) ")


@dataclasses.dataclass(frozen=True)
class Call:
    """A call to the other version: the arguments, the answer, and what the other's handler prints (None: it is not called)."""

    arguments: str = ""
    answer: str = "done"
    heard: str | None = ""
    flood: str = ""  # the argument of many that are sent before it and await no answer; a handler need not hear them all


@dataclasses.dataclass(frozen=True)
class Command:
    signature: str  # "double share() const"
    says: str = ""
    calls: tuple[Call, ...] = ()
    gives: str = ""  # what a provider of this version returns
    above: str = ""  # a doc comment

    @property
    def name(self):
        return re.search(r"(\w+)\(", self.implemented).group(1)

    @property
    def implemented(self):
        return ANNOTATION.sub("", self.signature)

    @property
    def parameters(self):
        listed = self.implemented[self.implemented.index("(") + 1:self.implemented.rindex(")")]
        return [one.split()[-1].lstrip("&") for one in listed.split(", ") if one]

    @property
    def is_const(self):
        return self.signature.endswith("const")

    def declaration(self):
        return f"{self.above}  SUTURE_COMMAND({self.says}) virtual {self.signature} = 0;\n"


@dataclasses.dataclass(frozen=True)
class Event:
    name: str
    payload: str  # "double, bool"
    says: str = ""
    emits: str = ""
    heard: str | None = None  # what this version gets of the other; None: nothing

    def declaration(self):
        return f"  SUTURE_EVENT({self.says}) suture::EventOf<{self.payload}> {self.name};\n"


@dataclasses.dataclass(frozen=True)
class Side:
    """This is the contract before the edit, or behind it. A struct "{T}" travels by command, event, row and answer."""

    types: str = ""
    commands: tuple[Command, ...] = ()
    events: tuple[Event, ...] = ()
    sends: dict[str, str] = dataclasses.field(default_factory=dict)  # members of {T} and what they are given
    sees: dict[str, str] = dataclasses.field(default_factory=dict)  # members and what comes from the other version
    says: str = ""  # SUTURE_INTERFACE(...)
    base: str = ""
    elsewhere: str = ""  # types that stand in another header of the namespace
    space: str = "edits"

    @property
    def has_struct(self):
        return re.search(r"struct SUTURE_TYPE\([^\n]*\) \{T\}[ :{]", self.types + self.elsewhere) is not None


def second_contract(name, says=""):
    """Returns a side with a contract beside the one in use."""
    return Side(types="class SUTURE_INTERFACE(%s) {T}%s {\n public:\n  virtual ~{T}%s() = default;\n%s};\n" % (
        says, name, name, Command("void last()").declaration()))


@dataclasses.dataclass(frozen=True)
class Edit:
    name: str
    page: str  # the row of docs/evolution.md that speaks of it
    old: Side
    new: Side
    build: str = ""  # a plain build: the slug of its errors or warnings, "" when it is silent
    update: str = ""  # --update-lock: the slug, "" when it writes
    accept: str = ""  # --update-lock --accept-break
    diff: str = FINE
    between: Side | None = None  # a version that was locked on the way
    inherited: bool = False  # its commands and events stand in a contract that the one in use derives from
    refusal: tuple[str, str] = ("", "")  # of what breaks: how a refusal names what is new and what was before

    @property
    def title(self):
        """ "a field added" -> "AFieldAdded": its types and its contract are called so."""
        return "".join(word.capitalize() for word in re.findall(r"\w+", self.name))

    @property
    def stem(self):
        return "_".join(re.findall(r"\w+", self.name)).lower()

    def text(self, text):
        return text.replace("{T}", self.title)
