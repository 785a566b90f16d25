#include "compiler/frontend/annotation.h"

#include <clang/AST/DeclCXX.h>
#include <clang/AST/Expr.h>

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
  std::string_view arguments;  // that it takes, for messages and checks
};

constexpr std::array kKinds{
    KindInfo{Kind::Type, "suture::type", "SUTURE_TYPE", "name()"},
    KindInfo{Kind::Field, "suture::field", "SUTURE_FIELD",
             "unit(), range(), capacity(), name(), was(), skip()"},
    KindInfo{Kind::Interface, "suture::interface", "SUTURE_INTERFACE", "name()"},
    KindInfo{Kind::Command, "suture::command", "SUTURE_COMMAND",
             "queue(), latest(), ttl(), name(), was()"},
    KindInfo{Kind::Event, "suture::event", "SUTURE_EVENT",
             "queue(), latest(), latched(), name(), was()"},
    KindInfo{Kind::Component, "suture::component", "SUTURE_COMPONENT", ""},
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
  return literal->getString().str();
}

/// The dsl name of an argument, as "capacity" for a value of type suture::dsl::Capacity.
std::string nameOf(const clang::Expr* argument) {
  const auto* record = argument->getType()->getAsCXXRecordDecl();
  if (!record || record->getName().empty()) return "";
  std::string name = record->getName().str();
  name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
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

class Reader {
 public:
  Reader(Kind kind, std::vector<AnnotationProblem>& problems) : problems_(problems) {
    result_.kind = kind;
  }

  void read(const clang::AnnotateAttr* attribute) {
    result_.arguments += attribute->args_size();
    for (const clang::Expr* argument : attribute->args()) readArgument(argument);
  }

  Annotation result() && { return std::move(result_); }

 private:
  void readArgument(const clang::Expr* argument) {
    const std::string name = nameOf(argument);
    const std::optional<clang::APValue> value = constantOf(argument);
    const KindInfo& info = infoOf(result_.kind);
    const std::string macro = std::string(info.macro) + "()";
    if (!value || name.empty()) {
      problem("bad-argument", "an argument of " + macro + " is not a call with constant values",
              "write it as a call, such as unit(\"m\") or latest()");
    } else if (info.arguments.find(name + "()") == std::string_view::npos) {
      problem("misplaced-argument", name + "() does not apply to " + macro,
              info.arguments.empty() ? macro + " takes no arguments"
                                     : "it takes " + std::string(info.arguments));
    } else if (!seen_.insert(name).second) {
      problem("repeated-argument", name + "() is given twice", "keep one of them");
    } else {
      store(name, *value);
    }
  }

  void store(const std::string& name, const clang::APValue& value) {
    const clang::APValue& first = value.getStructField(0);
    if (name == "unit" || name == "was" || name == "name") return storeText(name, first);
    if (name == "range") {
      result_.range = {first.getFloat().convertToDouble(),
                       value.getStructField(1).getFloat().convertToDouble()};
    } else if (name == "capacity") {
      result_.capacity = capacityOf(value);
    } else if (name == "queue") {
      result_.queue = static_cast<unsigned>(first.getInt().getZExtValue());
    } else if (name == "ttl") {
      result_.ttlNanoseconds = first.getInt().getSExtValue();
    } else if (name == "latest") {
      result_.latest = true;
    } else if (name == "latched") {
      result_.latched = true;
    } else if (name == "skip") {
      result_.skip = true;
    }
  }

  void storeText(const std::string& name, const clang::APValue& value) {
    const std::optional<std::string> text = textOf(value);
    if (!text || text->empty()) {
      problem("bad-argument", name + "() needs a non-empty string literal",
              "write it as " + name + "(\"...\")");
    } else if (name == "unit") {
      result_.unit = *text;
    } else {
      (name == "was" ? result_.was : result_.name) = text;
    }
  }

  void problem(std::string slug, std::string message, std::string help) {
    problems_.push_back({std::move(slug), std::move(message), std::move(help)});
  }

  Annotation result_;
  std::set<std::string> seen_;
  std::vector<AnnotationProblem>& problems_;
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
