#pragma once
// Reads what a SUTURE_ macro left on a declaration.

#include <clang/AST/ASTContext.h>
#include <clang/AST/Attr.h>
#include <clang/AST/Decl.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace suture::compiler::frontend {

enum class Kind { Type, Field, Interface, Command, Event, Component, Required, External };

/// "SUTURE_TYPE" for messages.
std::string macroOf(Kind kind);

struct ExternalMember;

struct Annotation {
  Kind kind = Kind::Type;
  std::string unit;
  std::optional<std::pair<double, double>> range;
  std::vector<unsigned> capacity;  ///< outside in; empty = none said
  std::optional<std::string> was, name;
  std::optional<unsigned> queue;
  std::optional<std::int64_t> ttlNanoseconds;
  std::optional<std::int64_t> deadlineNanoseconds, maxAgeNanoseconds;
  std::optional<unsigned> version, since;
  std::string deprecated;
  bool latest = false;
  bool latched = false;
  bool optional = false;
  bool concurrent = false;
  bool direct = false;
  bool crtk = false;
  bool skip = false;
  bool fallback = false;
  bool bulk = false;
  bool all = false;
  unsigned arguments = 0;               ///< how many were given
  std::vector<ExternalMember> members;  ///< of an external type, as listed
};

struct ExternalMember {
  const clang::FieldDecl* field = nullptr;
  Annotation annotation;
  clang::SourceLocation place{};  ///< where SUTURE_EXTERNAL_TYPE names it
};

/// Whether a macro of that name annotates.
bool isVocabulary(llvm::StringRef macro);

/// "unit", "range"...: what any of the macros takes.
std::vector<std::string_view> annotationArguments();

/// Says what is wrong with an annotation's arguments.
struct AnnotationProblem {
  std::string slug, message, help;
  clang::SourceLocation place;  ///< of the member that is listed; invalid: at the declaration
};

/// Whether the declaration bears the macro.
bool isAnnotated(const clang::Decl* declaration, Kind kind);

/// The kinds of all Suture annotations on the declaration, in the order written.
std::vector<Kind> annotationKinds(const clang::Decl* declaration);

/// The annotation of that kind; a default one if there is none. Problems are appended.
Annotation readAnnotation(const clang::Decl* declaration, Kind kind,
                          std::vector<AnnotationProblem>& problems);

/// Where a macro may stand more than once: one annotation for each, in the order of the text.
std::vector<Annotation> readEach(const clang::Decl* declaration, Kind kind,
                                 std::vector<AnnotationProblem>& problems);

}  // namespace suture::compiler::frontend
