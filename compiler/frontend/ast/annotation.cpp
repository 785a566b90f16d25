#include "compiler/frontend/ast/annotation.h"

#include <clang/AST/DeclCXX.h>
#include <clang/AST/Expr.h>
#include <llvm/Support/JSON.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace suture::compiler::frontend {
namespace {

struct KindInfo {
  Kind kind;
  std::string_view tag;        // in the clang::annotate attribute
  std::string_view macro;      // as the user wrote it
  std::string_view arguments;  // those that it takes, for messages and checks
};

constexpr std::array kKinds{
    KindInfo{Kind::Type, "suture::type", "SUTURE_TYPE", "name(), was(), since(), deprecated()"},
    KindInfo{Kind::Field, "suture::field", "SUTURE_FIELD",
             "unit(), range(), capacity(), bulk(), name(), was(), since(), deprecated(), skip(), "
             "fallback()"},
    KindInfo{Kind::Interface, "suture::interface", "SUTURE_INTERFACE",
             "crtk(), version(), name(), was(), since(), deprecated()"},
    KindInfo{Kind::Command, "suture::command", "SUTURE_COMMAND",
             "queue(), latest(), ttl(), deadline(), concurrent(), direct(), optional(), name(), "
             "was(), since(), deprecated()"},
    KindInfo{Kind::Event, "suture::event", "SUTURE_EVENT",
             "queue(), latest(), latched(), name(), was(), since(), deprecated()"},
    KindInfo{Kind::Component, "suture::component", "SUTURE_COMPONENT", "optional(), max_age()"},
    KindInfo{Kind::Required, "suture::required", "SUTURE_REQUIRED", "optional(), max_age()"},
    KindInfo{Kind::External, "suture::external", "SUTURE_EXTERNAL_TYPE", "all(), member(), name()"},
};

const KindInfo& infoOf(Kind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

const KindInfo* infoOf(const clang::AnnotateAttr* attribute) {
  for (const KindInfo& info : kKinds) {
    if (attribute->getAnnotation() == llvm::StringRef(info.tag)) return &info;
  }
  return nullptr;
}

std::optional<clang::APValue> constantOf(const clang::Expr* argument) {
  const auto* constant = llvm::dyn_cast<clang::ConstantExpr>(argument);
  if (!constant || !constant->hasAPValueResult()) return std::nullopt;
  clang::APValue value = constant->getAPValueResult();
  if (!value.isStruct()) return std::nullopt;
  return value;
}

std::optional<std::string> textOf(const clang::APValue& value) {
  if (!value.isLValue() || value.isNullPointer()) return std::nullopt;
  const auto* base = value.getLValueBase().dyn_cast<const clang::Expr*>();
  const auto* literal = llvm::dyn_cast_or_null<clang::StringLiteral>(base);
  if (!literal || !value.getLValueOffset().isZero() || literal->getCharByteWidth() != 1) {
    return std::nullopt;
  }
  return asUtf8(literal->getString());
}

/// Returns the dsl name of an argument: "max_age" for a value of type suture::dsl::MaxAge.
std::string nameOf(clang::QualType type) {
  const auto* record = type->getAsCXXRecordDecl();
  if (!record) return "";
  std::string name;
  for (const char c : record->getName()) {
    const bool capital = std::isupper(static_cast<unsigned char>(c)) != 0;
    if (capital && !name.empty()) name += '_';
    name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return name;
}

std::vector<unsigned> capacityOf(const clang::APValue& value) {
  std::vector<unsigned> levels;
  for (unsigned i = 0; i < value.getStructNumFields(); ++i) {
    levels.push_back(static_cast<unsigned>(value.getStructField(i).getInt().getZExtValue()));
  }
  while (levels.size() > 1 && levels.back() == 0) levels.pop_back();
  return levels;
}

/// Returns what dsl::member(noexcept(any<Type>().m), ...) names, or null if the argument has
/// another form.
const clang::MemberExpr* mentionedMember(const clang::Stmt* argument) {
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(argument)) return member;
  for (const clang::Stmt* child : argument->children()) {
    const clang::MemberExpr* const found = child ? mentionedMember(child) : nullptr;
    if (found != nullptr) return found;
  }
  return nullptr;
}

/// Finds where dsl::member(&Type::m, ...) names m.
clang::SourceLocation memberPlace(const clang::Stmt* argument) {
  if (const auto* mentioned = mentionedMember(argument)) return mentioned->getMemberLoc();
  if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(argument)) {
    if (!llvm::isa<clang::FunctionDecl>(reference->getDecl()) ||
        llvm::isa<clang::CXXMethodDecl>(reference->getDecl())) {
      return reference->getLocation();
    }
  }
  for (const clang::Stmt* child : argument->children()) {
    const clang::SourceLocation place = child ? memberPlace(child) : clang::SourceLocation();
    if (place.isValid()) return place;
  }
  return {};
}

class Reader {
 public:
  Reader(Kind kind, std::vector<AnnotationProblem>& problems, clang::SourceLocation place = {})
      : problems_(problems), place_(place) {
    result_.kind = kind;
  }

  void read(const clang::AnnotateAttr* attribute) {
    result_.arguments += attribute->args_size();
    for (const clang::Expr* argument : attribute->args()) readArgument(argument);
  }

  Annotation result() && { return std::move(result_); }

 private:
  void readArgument(const clang::Expr* argument) {
    const std::optional<clang::APValue> value = constantOf(argument);
    if (nameOf(argument->getType()) == "member") {
      place_ = memberPlace(argument);
      mentioned_ = mentionedMember(argument);
    }
    readValue(argument->getType(), value);
  }

  void readValue(clang::QualType type, const std::optional<clang::APValue>& value) {
    const std::string name = nameOf(type);
    const KindInfo& info = infoOf(result_.kind);
    const std::string macro = std::string(info.macro) + "()";
    if (!value || name.empty()) {
      problem("bad-argument", "an argument of " + macro + " is not a call with constant values",
              "write it as a call, such as unit(\"m\") or latest()");
    } else if (info.arguments.find(name + "()") == std::string_view::npos) {
      problem("misplaced-argument", name + "() does not apply to " + macro,
              info.arguments.empty() ? macro + " takes no arguments"
                                     : "it takes " + std::string(info.arguments));
    } else if (name == "member") {
      readMember(type, *value);
    } else if (!seen_.insert(name).second) {
      problem("repeated-argument", name + "() is given twice", "keep one of them");
    } else {
      store(name, *value);
    }
  }

  void store(const std::string& name, const clang::APValue& value) {
    const clang::APValue& first = value.getStructField(0);
    if (name == "range") {
      result_.range = {first.getFloat().convertToDouble(),
                       value.getStructField(1).getFloat().convertToDouble()};
    } else if (name == "capacity") {
      result_.capacity = capacityOf(value);
    } else if (std::optional<unsigned>* number = numberOf(name)) {
      *number = static_cast<unsigned>(first.getInt().getZExtValue());
    } else if (std::optional<std::int64_t>* time = timeOf(name)) {
      *time = first.getInt().getSExtValue();
    } else if (bool* flag = flagOf(name)) {
      *flag = true;
    } else {
      storeText(name, first);
    }
  }

  std::optional<unsigned>* numberOf(const std::string& name) {
    if (name == "queue") return &result_.queue;
    if (name == "version") return &result_.version;
    return name == "since" ? &result_.since : nullptr;
  }

  std::optional<std::int64_t>* timeOf(const std::string& name) {
    if (name == "ttl") return &result_.ttlNanoseconds;
    if (name == "deadline") return &result_.deadlineNanoseconds;
    return name == "max_age" ? &result_.maxAgeNanoseconds : nullptr;
  }

  bool* flagOf(const std::string& name) {
    if (name == "latest") return &result_.latest;
    if (name == "latched") return &result_.latched;
    if (name == "optional") return &result_.optional;
    if (name == "concurrent") return &result_.concurrent;
    if (name == "direct") return &result_.direct;
    if (name == "skip") return &result_.skip;
    if (name == "fallback") return &result_.fallback;
    if (name == "bulk") return &result_.bulk;
    if (name == "all") return &result_.all;
    return name == "crtk" ? &result_.crtk : nullptr;
  }

  /// Reads a member, whose qualifiers are the bases of the value.
  void readMember(clang::QualType type, const clang::APValue& value) {
    const clang::ValueDecl* const named = mentioned_ != nullptr
                                              ? mentioned_->getMemberDecl()
                                              : value.getStructField(0).getMemberPointerDecl();
    const auto* field = llvm::dyn_cast_or_null<clang::FieldDecl>(named);
    if (!field) {
      return problem("bad-argument", "an argument of SUTURE_EXTERNAL_TYPE() is not a data member",
                     "list data members of the type");
    }
    Reader inner(Kind::Field, problems_, place_);
    unsigned index = 0;
    for (const clang::CXXBaseSpecifier& base : type->getAsCXXRecordDecl()->bases()) {
      inner.readValue(base.getType(), value.getStructBase(index++));
    }
    result_.members.push_back({field, std::move(inner).result(), place_});
  }

  void storeText(const std::string& name, const clang::APValue& value) {
    const std::optional<std::string> text = textOf(value);
    if (!text || text->empty()) {
      problem("bad-argument", name + "() needs a non-empty string literal",
              "write it as " + name + "(\"...\")");
    } else if (name == "unit") {
      result_.unit = *text;
    } else if (name == "deprecated") {
      result_.deprecated = *text;
    } else {
      (name == "was" ? result_.was : result_.name) = text;
    }
  }

  void problem(std::string slug, std::string message, std::string help) {
    problems_.push_back({std::move(slug), std::move(message), std::move(help), place_});
  }

  Annotation result_;
  std::set<std::string> seen_;
  std::vector<AnnotationProblem>& problems_;
  clang::SourceLocation place_;                   // where the member stands that is being read
  const clang::MemberExpr* mentioned_ = nullptr;  // that member, if no pointer to it can be had
};

}  // namespace

bool isVocabulary(llvm::StringRef macro) {
  return std::any_of(kKinds.begin(), kKinds.end(), [macro](const KindInfo& info) {
    return macro == llvm::StringRef(info.macro);
  });
}

std::vector<std::string_view> annotationArguments() {
  std::vector<std::string_view> names;
  for (const KindInfo& info : kKinds) {
    std::string_view rest = info.arguments;
    for (std::size_t end; (end = rest.find("()")) != std::string_view::npos;) {
      names.push_back(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 4, rest.size()));  // "(), "
    }
  }
  return names;
}

std::string asUtf8(llvm::StringRef text) {
  if (llvm::json::isUTF8(text)) return text.str();
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80) result += static_cast<char>(0xC0 | byte >> 6);
    result += byte < 0x80 ? c : static_cast<char>(0x80 | (byte & 0x3F));
  }
  return result;
}

std::string macroOf(Kind kind) { return std::string(infoOf(kind).macro); }

std::vector<Kind> annotationKinds(const clang::Decl* declaration) {
  std::vector<Kind> kinds;
  for (const auto* attribute : declaration->specific_attrs<clang::AnnotateAttr>()) {
    if (const KindInfo* info = infoOf(attribute)) kinds.push_back(info->kind);
  }
  return kinds;
}

bool isAnnotated(const clang::Decl* declaration, Kind kind) {
  for (const Kind found : annotationKinds(declaration)) {
    if (found == kind) return true;
  }
  return false;
}

std::vector<Annotation> readEach(const clang::Decl* declaration, Kind kind,
                                 std::vector<AnnotationProblem>& problems) {
  std::vector<Annotation> all;
  for (const auto* attribute : declaration->specific_attrs<clang::AnnotateAttr>()) {
    const KindInfo* info = infoOf(attribute);
    if (!info || info->kind != kind) continue;
    Reader reader(kind, problems);
    reader.read(attribute);
    all.push_back(std::move(reader).result());
  }
  return all;
}

Annotation readAnnotation(const clang::Decl* declaration, Kind kind,
                          std::vector<AnnotationProblem>& problems) {
  Reader reader(kind, problems);
  for (const auto* attribute : declaration->specific_attrs<clang::AnnotateAttr>()) {
    const KindInfo* info = infoOf(attribute);
    if (info && info->kind == kind && !attribute->isInherited()) reader.read(attribute);
  }
  return std::move(reader).result();
}

}  // namespace suture::compiler::frontend
