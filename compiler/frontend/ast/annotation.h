#pragma once
// This reads what a SUTURE_ macro left on a declaration.

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

/// Returns the text itself if it is UTF-8, else what it says if it is Latin-1, as in old headers:
/// schemas and JSON hold nothing but UTF-8.
std::string asUtf8(llvm::StringRef text);

/// Returns the macro's name for messages, such as "SUTURE_TYPE".
std::string macroOf(Kind kind);

struct ExternalMember;

struct Annotation {
  Kind kind = Kind::Type;
  std::string unit;
  std::optional<std::pair<double, double>> range;
  std::vector<unsigned> capacity;  ///< outside in; empty if none was said
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
  std::vector<ExternalMember> members;  ///< those that an external type lists
};

struct ExternalMember {
  const clang::FieldDecl* field = nullptr;
  Annotation annotation;
  clang::SourceLocation place{};  ///< where SUTURE_EXTERNAL_TYPE names it
};

/// Tells if a macro of that name annotates.
bool isVocabulary(llvm::StringRef macro);

/// Returns what any of the macros takes: "unit", "range" and so on.
std::vector<std::string_view> annotationArguments();

/// Says what is wrong with an annotation's arguments.
struct AnnotationProblem {
  std::string slug, message, help;
  clang::SourceLocation place;  ///< the listed member's; invalid: the declaration's
};

/// Tells if the declaration bears the macro.
bool isAnnotated(const clang::Decl* declaration, Kind kind);

/// Returns the kinds of all Suture annotations on the declaration, in the order written.
std::vector<Kind> annotationKinds(const clang::Decl* declaration);

/// Returns the annotation of that kind, or a default one if there is none. It appends problems.
Annotation readAnnotation(const clang::Decl* declaration, Kind kind,
                          std::vector<AnnotationProblem>& problems);

/// Returns one annotation for each time that the macro stands there, in the order of the text.
std::vector<Annotation> readEach(const clang::Decl* declaration, Kind kind,
                                 std::vector<AnnotationProblem>& problems);

}  // namespace suture::compiler::frontend
