"""Names that Cap'n Proto's language, its C++, the standard library's C++ or suturec's generated code has a use for itself."""

# These are names of types, each with its name on the wire (docs/types.md): what Cap'n Proto needs there gets a word more.
ESCAPED = ["Text", "Data", "List", "Void", "Bool", "Int8", "UInt64", "Float32", "AnyPointer", "AnyStruct", "Capability",
           "Reader", "Builder", "Pipeline", "Cxx", "Meta"]
PLAIN = ["Client", "Server", "Slot", "Wire", "Value", "Which", "Union", "Group", "Struct", "Enum", "Interface", "Import",
         "Kj", "Capnp", "Std", "Arguments", "State", "Events", "Request", "Element", "Orphan", "Message", "Result", "Item0"]
TYPES = {**{name: name + "Type" for name in ESCAPED}, **{name: name for name in PLAIN}}

# These are names of members. Some are one name on the wire, where `foo_bar` is `fooBar` and a base class is `base`.
MEMBERS = ["text", "list", "data", "reader", "builder", "group", "which", "stamp", "sent", "get", "set", "has", "init",
           "adopt", "disown", "value", "self", "slot", "wire", "name", "eof", "emit", "id", "type", "suture", "kj",
           "capnp", "in", "out", "result", "arguments", "count", "size", "begin", "end", "index", "path", "some", "none",
           "item0", "item1", "key", "entry", "element", "error", "root", "message", "import_", "struct_", "interface",
           "annotation", "const_", "using_", "void_", "fooBar", "text_value", "valueText", "store", "load", "reserve",
           "to_wire", "from_wire", "isValid", "other", "i", "n", "it", "maxAge", "base", "foo_bar", "Count", "as", "of", "from", "with", "now"]
# These are names of commands and events that the classes of generated code use.
COMMANDS = [*MEMBERS, "Command", "ReadCommand", "QualifiedReadCommand", "ReturningCommand", "NoSlot", "Component", "interfaceInfo",
            "InterfaceInfo", "RequiredBase", "ProvidedBase", "Subscription", "Emitter", "Errc", "Dispatch", "Scratch", "execute"]
# These stand beside `First`.
ENUMERATORS = ["first", "FIRST", "eof", "nan", "overflow", "null", "text", "which", "union_", "enumerant", "value", "domain",
               "unknown", "none", "some"]
