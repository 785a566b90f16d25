#include "compiler/model/reserved_names.h"

#include <algorithm>
#include <array>

#include "compiler/model/naming.h"

namespace suture::compiler::model {
namespace {

/// These are types of Cap'n Proto's language, and two files that every schema of ours imports under
/// these names.
constexpr std::array<std::string_view, 21> kLanguage{
    "Void",   "Bool",       "Int8",    "Int16",     "Int32",      "Int64", "UInt8",
    "UInt16", "UInt32",     "UInt64",  "Float32",   "Float64",    "Text",  "Data",
    "List",   "AnyPointer", "AnyList", "AnyStruct", "Capability", "Cxx",   "Meta"};

/// These are what capnp's C++ declares in the class of each struct, and of each interface.
constexpr std::array<std::string_view, 3> kInStructs{"Reader", "Builder", "Pipeline"};
constexpr std::array<std::string_view, 2> kInInterfaces{"Client", "Server"};

/// These are macros of the C library, as capnp would spell an enumerator.
constexpr std::array<std::string_view, 16> kMacros{
    "EOF",     "NAN",     "INFINITY", "BUFSIZ",   "SEEK_SET",  "SEEK_CUR", "SEEK_END", "RAND_MAX",
    "INT_MAX", "INT_MIN", "CHAR_BIT", "OVERFLOW", "UNDERFLOW", "DOMAIN",   "SIGINT",   "ERANGE"};

template <class Names>
bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

const char* wordFor(Named kind) {
  switch (kind) {
    case Named::Type: return "Type";
    case Named::Contract: return "Interface";
    case Named::Command:
    case Named::Read: return "Command";
    case Named::Event: return "Event";
    case Named::Enumerator:
    case Named::Parameter: break;
  }
  return "Value";
}

}  // namespace

bool isReserved(Named kind, std::string_view wireName) {
  switch (kind) {
    case Named::Type: return contains(kLanguage, wireName) || contains(kInStructs, wireName);
    case Named::Contract:
      return isReserved(Named::Type, wireName) || contains(kInInterfaces, wireName);
    case Named::Enumerator: return contains(kMacros, upperSnakeCase(wireName));
    case Named::Read:
      if (contains(kBuiltInColumns, wireName)) return true;
      [[fallthrough]];
    case Named::Command: return wireName == kBuiltInMethod;
    case Named::Parameter: return wireName == kBuiltInParameter;
    case Named::Event: return contains(kBuiltInEvents, wireName);
  }
  return false;
}

std::string freeName(Named kind, std::string wireName) {
  return isReserved(kind, wireName) ? wireName + wordFor(kind) : wireName;
}

}  // namespace suture::compiler::model
