#include "compiler/lock/schema/parse.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "compiler/lock/schema/meta_annotations.h"
#include "compiler/lock/schema/tokens.h"
#include "compiler/lock/schema/wire_type.h"

namespace suture::compiler::lock {
namespace {

constexpr std::string_view kMeta = "Meta.";
constexpr unsigned kDeepest = 64;                 // capnp's readers follow no deeper
constexpr std::uint64_t kLargestOrdinal = 65534;  // capnp counts in 16 bits

class Parser {
 public:
  explicit Parser(std::string_view text) : tokens_(tokenize(text)) {}

  Lock file() {
    Lock lock;
    lock.id = id();
    expect(";");
    while (!peek().text.empty()) {
      if (peek().text == "using") {
        import();
      } else if (peek().text == "$") {
        fileAnnotation(lock);
      } else {
        lock.nodes.push_back(node());
      }
    }
    return lock;
  }

 private:
  const Token& peek() const { return tokens_[at_]; }

  Token take() {
    if (peek().text.empty()) throw SyntaxError(peek().line, "the file ends too early");
    return tokens_[at_++];
  }

  bool accept(const std::string& text) {
    const bool found = peek().text == text;
    if (found) ++at_;
    return found;
  }

  void expect(const std::string& text) {
    if (accept(text)) return;
    const std::string found = peek().text.empty() ? "the end of the file" : "'" + peek().text + "'";
    throw SyntaxError(peek().line, "expected '" + text + "', found " + found);
  }

  /// Takes a name that a lock declares: it has letters and digits only.
  std::string name() {
    const Token token = take();
    const bool good = std::all_of(token.text.begin(), token.text.end(), [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0;
    });
    if (!good) throw SyntaxError(token.line, "expected a name, found '" + token.text + "'");
    return token.text;
  }

  std::uint64_t number() {
    const Token token = take();
    char* end = nullptr;
    const std::uint64_t value = std::strtoull(token.text.c_str(), &end, 0);
    if (*end != '\0')
      throw SyntaxError(token.line, "expected a number, found '" + token.text + "'");
    return value;
  }

  std::uint64_t id() {
    expect("@");
    const unsigned line = peek().line;
    const std::uint64_t value = number();
    if (value >> 63 == 0) throw SyntaxError(line, "an id must have its top bit set");
    return value;
  }

  void import() {
    expect("using");
    const std::string alias = take().text;
    expect("=");
    expect("import");
    const Token literal = take();
    const std::string path = unquoted(literal.text);
    const bool plain = path.find_first_of(":()\"\\ \t\r\n") == std::string::npos;
    if (!path.starts_with('/') || !path.ends_with(".capnp") || !plain) {
      throw SyntaxError(literal.line, literal.text + " is no path of a schema: \"/arm/arm.capnp\"");
    }
    imports_[alias] = path;
    expect(";");
  }

  static bool isKnown(std::string_view annotation) {
    return std::find(std::begin(kMetaAnnotations), std::end(kMetaAnnotations), annotation) !=
           std::end(kMetaAnnotations);
  }

  /// Returns {"Meta.unit", "\"m\""} for "$Meta.unit("m")". Callers keep annotations of others out
  /// of the lock.
  std::pair<std::string, std::string> annotation() {
    expect("$");
    const Token name = take();
    std::string argument;
    if (peek().text == "(") argument = argumentText();
    const std::size_t dot = name.text.find('.');
    if (dot == std::string::npos)
      throw SyntaxError(name.line, "unknown annotation '" + name.text + "'");
    if (name.text.starts_with(kMeta) && !isKnown(name.text.substr(kMeta.size()))) {
      throw SyntaxError(name.line, "it says " + name.text + ", which this suturec does not know",
                        SyntaxError::Kind::Newer);
    }
    return {name.text, argument};
  }

  /// Returns a value, or the fields of a struct with the parentheses, spaced as the writer spaces
  /// it.
  std::string argumentText() {
    expect("(");
    std::string text;
    const bool isStruct = !peek().text.empty() && tokens_[at_ + 1].text == "=";
    if (!isStruct) {
      text = value();
    } else {
      do {
        text += (text.empty() ? "(" : ", ") + name();
        expect("=");
        text += " = " + value();
      } while (accept(","));
      text += ")";
    }
    expect(")");
    return text;
  }

  /// Returns a number, a name, a string or a list of them.
  std::string value(unsigned depth = 0) {
    if (depth > kDeepest) throw SyntaxError(peek().line, "a value is nested too deeply");
    if (!accept("[")) {
      const Token literal = take();
      const char first = literal.text.front();
      if (first == '"' || first == '-' || std::isalnum(static_cast<unsigned char>(first))) {
        return literal.text;
      }
      throw SyntaxError(literal.line, "expected a value, found '" + literal.text + "'");
    }
    std::string text = "[" + value(depth + 1);
    while (accept(",")) text += ", " + value(depth + 1);
    expect("]");
    return text + "]";
  }

  Annotations annotations() {
    Annotations result;
    while (peek().text == "$") {
      auto [name, argument] = annotation();
      if (name.starts_with(kMeta)) result.emplace(name.substr(kMeta.size()), std::move(argument));
    }
    return result;
  }

  void fileAnnotation(Lock& lock) {
    const auto [name, argument] = annotation();
    const std::string value = unquoted(argument);
    if (name == "Cxx.namespace") {
      const std::size_t suffix = value.rfind("::wire");
      lock.cxxNamespace = suffix == std::string::npos ? "" : value.substr(0, suffix);
    }
    if (name == "Meta.header") lock.header = value;
    if (name == "Meta.formerly") lock.departures.push_back(departure(value));
    expect(";");
  }

  /// Returns what "Pose @0x9b87d70f9fe9600f /arm/arm.capnp:Placement" says.
  Departure departure(const std::string& text) const {
    std::istringstream words(text);
    std::string name, number, place, more;
    words >> name >> number >> place >> more;
    char* end = nullptr;
    const bool hasNumber = number.starts_with("@0x");
    const std::uint64_t id = hasNumber ? std::strtoull(number.c_str() + 1, &end, 16) : 0;
    const TypePlace to = placeOf(place, "");
    const bool isPlain = text.find_first_of("\"\\()") == std::string::npos;
    const bool isWhole = isPlain && more.empty() && !to.path.empty() && !to.name.empty();
    if (id >> 63 == 0 || *end != '\0' || !isWhole) {
      throw SyntaxError(peek().line, "expected \"Name @0xid /path:Name\", found \"" + text + "\"");
    }
    return {name, id, to};
  }

  /// Returns the type with the alias resolved: "List(/arm/arm.capnp:Pose)" for "List(Arm.Pose)".
  std::string type(unsigned depth = 0) {
    const Token name = take();
    if (depth > kDeepest) throw SyntaxError(name.line, "a type is nested too deeply");
    const char first = name.text.empty() ? '\0' : name.text.front();
    if (std::isalpha(static_cast<unsigned char>(first)) == 0) {
      throw SyntaxError(name.line, "expected a type, found '" + name.text + "'");
    }
    if (name.text == "List") {
      expect("(");
      const std::string element = type(depth + 1);
      expect(")");
      return "List(" + element + ")";
    }
    const std::size_t dot = name.text.find('.');
    if (dot == std::string::npos) return name.text;
    const auto import = imports_.find(name.text.substr(0, dot));
    if (import == imports_.end()) {
      throw SyntaxError(name.line, "'" + name.text + "' is of a file that is not imported");
    }
    return import->second + ":" + name.text.substr(dot + 1);
  }

  std::vector<std::string> bases() {
    std::vector<std::string> types;
    expect("(");
    while (!accept(")")) {
      if (!types.empty()) expect(",");
      types.push_back(type());
    }
    return types;
  }

  std::vector<Member> list() {
    std::vector<Member> members;
    expect("(");
    while (!accept(")")) {
      if (!members.empty()) expect(",");
      Member member;
      member.line = peek().line;
      member.name = name();
      expect(":");
      member.type = type();
      member.annotations = annotations();
      members.push_back(std::move(member));
    }
    return members;
  }

  Member member() {
    Member result;
    result.line = peek().line;
    result.name = name();
    expect("@");
    const std::uint64_t ordinal = number();
    if (ordinal > kLargestOrdinal) {
      throw SyntaxError(result.line, "'" + result.name + "' has no ordinal that capnp knows");
    }
    result.ordinal = static_cast<unsigned>(ordinal);
    if (peek().text == "(") {
      result.isMethod = true;
      result.parameters = list();
      expect("->");
      result.results = list();
    } else if (accept(":")) {
      result.type = type();
      if (accept("=")) result.defaultValue = value();
    }
    result.annotations = annotations();
    expect(";");
    return result;
  }

  /// Takes "union {", and returns true, if it stands here; then the union is all that the struct
  /// holds. A member may be called "union" too, so the brace decides.
  bool opensUnion() {
    if (peek().text != "union" || tokens_[at_ + 1].text != "{") return false;
    at_ += 2;
    return true;
  }

  Node node() {
    static const std::map<std::string, Node::Kind> kinds = {{"struct", Node::Kind::Struct},
                                                            {"enum", Node::Kind::Enum},
                                                            {"interface", Node::Kind::Interface}};
    Node result;
    result.line = peek().line;
    const std::string keyword = take().text;
    const auto kind = kinds.find(keyword);
    if (kind == kinds.end()) {
      throw SyntaxError(result.line, "expected struct, enum or interface, found '" + keyword + "'");
    }
    result.kind = kind->second;
    result.name = name();
    result.id = id();
    if (accept("extends")) result.extends = bases();
    result.annotations = annotations();
    expect("{");
    result.isUnion = opensUnion();
    while (!accept("}")) result.members.push_back(member());
    if (result.isUnion) expect("}");
    return result;
  }

  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::map<std::string, std::string> imports_;
};

void refuseBadMembers(const Node& node) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < node.members.size(); ++i) {
    const Member& member = node.members[i];
    if (member.ordinal != i) {
      throw SyntaxError(member.line, "'" + member.name + "' has ordinal " +
                                         std::to_string(member.ordinal) + ", expected " +
                                         std::to_string(i) +
                                         ": ordinals count up from 0 without gap or repeat");
    }
    if (!names.insert(member.name).second) {
      throw SyntaxError(member.line, "'" + member.name + "' stands twice in " + node.name);
    }
  }
}

}  // namespace

Lock parse(std::string path, std::string_view text) {
  Lock lock = Parser(text).file();
  lock.path = std::move(path);
  lock.text = text;
  std::set<std::string> names;
  for (const Node& node : lock.nodes) {
    if (!names.insert(node.name).second) throw SyntaxError(node.line, node.name + " stands twice");
    refuseBadMembers(node);
  }
  return lock;
}

}  // namespace suture::compiler::lock
