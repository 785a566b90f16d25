#include "compiler/frontend/types/mapping.h"

#include <clang/AST/RawCommentList.h>

#include "compiler/frontend/types/field_fixes.h"
#include "compiler/frontend/types/platform_integers.h"
#include "compiler/frontend/types/type_mapper.h"
#include "compiler/model/quantities.h"

namespace suture::compiler::frontend {

model::Source Mapping::sourceOf(const clang::NamedDecl* declaration) {
  if (const auto foreign = foreign_.find(declaration); foreign != foreign_.end()) {
    return table_.add(sources(), foreign->second.place, clang::SourceRange());
  }
  // Underline the type of a field or parameter as well; for a class or method the caret is
  // enough.
  const bool typed =
      llvm::isa<clang::DeclaratorDecl>(declaration) && !llvm::isa<clang::FunctionDecl>(declaration);
  return table_.add(sources(), declaration->getLocation(),
                    typed
                        ? clang::SourceRange(declaration->getBeginLoc(), declaration->getLocation())
                        : clang::SourceRange());
}

model::Documentation Mapping::documentationOf(const clang::Decl* declaration) const {
  const clang::RawComment* comment = context_.getRawCommentForDeclNoCache(declaration);
  if (!comment) return {};
  const std::string text = comment->getFormattedText(sources(), context_.getDiagnostics());
  return {asUtf8(llvm::StringRef(text).trim())};
}

model::Diagnostic& Mapping::error(const clang::NamedDecl* declaration, std::string slug,
                                  std::string message, std::string help) {
  model::Diagnostic& finding =
      add(sourceOf(declaration), std::move(slug), std::move(message), std::move(help));
  const auto foreign = foreign_.find(declaration);
  if (foreign != foreign_.end() && foreign->second.wantedBy) {
    finding.notes.push_back(
        {sourceOf(foreign->second.wantedBy), "all public members are meant here"});
  }
  return finding;
}

model::Diagnostic& Mapping::errorAt(clang::SourceLocation place, std::string slug,
                                    std::string message, std::string help) {
  return add(table_.add(sources(), place, {}), std::move(slug), std::move(message),
             std::move(help));
}

model::Diagnostic& Mapping::add(model::Source source, std::string slug, std::string message,
                                std::string help) {
  model::Diagnostic finding;
  finding.source = std::move(source);
  finding.slug = std::move(slug);
  finding.message = std::move(message);
  finding.help = std::move(help);
  return findings_.emplace_back(std::move(finding));
}

model::Diagnostic& Mapping::warn(const clang::NamedDecl* declaration, std::string slug,
                                 std::string message, std::string help) {
  model::Diagnostic& finding =
      error(declaration, std::move(slug), std::move(message), std::move(help));
  finding.severity = model::Diagnostic::Severity::Warning;
  return finding;
}

model::Source Mapping::sourceOf(clang::SourceRange range) {
  return table_.add(sources(), range.getBegin(), range);
}

model::Fix Mapping::fix(clang::SourceRange range, model::Fix::Place place, std::string text) {
  return {sourceOf(range), place, std::move(text)};
}

Annotation Mapping::annotationOf(const clang::NamedDecl* declaration, Kind kind) {
  std::vector<AnnotationProblem> problems;
  Annotation annotation = readAnnotation(declaration, kind, problems);
  report(declaration, std::move(problems));
  return annotation;
}

std::vector<Annotation> Mapping::annotationsOf(const clang::NamedDecl* declaration, Kind kind) {
  std::vector<AnnotationProblem> problems;
  std::vector<Annotation> annotations = readEach(declaration, kind, problems);
  report(declaration, std::move(problems));
  return annotations;
}

void Mapping::report(const clang::NamedDecl* declaration, std::vector<AnnotationProblem> problems) {
  for (AnnotationProblem& problem : problems) {
    const model::Source source =
        problem.place.isValid() ? table_.add(sources(), sources().getFileLoc(problem.place), {})
                                : sourceOf(declaration);
    add(source, std::move(problem.slug), std::move(problem.message), std::move(problem.help));
  }
}

std::optional<model::Type> Mapping::typeOf(const clang::NamedDecl* declaration,
                                           clang::QualType type, const std::string& subject,
                                           const Annotation& field) {
  if (type->isConstantArrayType() && isAnnotated(declaration, Kind::Event)) {
    error(declaration, "c-array", subject + " is a C array, which is no value", "use std::array");
    return std::nullopt;
  }
  const bool foreign = isForeign(declaration);
  MappedType mapped = mapType(type, names_.within(foreign));
  if (const auto* problem = std::get_if<TypeProblem>(&mapped)) {
    model::Diagnostic& finding = error(
        declaration, problem->slug,
        subject + " of type '" + spelled(type, context_) + "': " + problem->reason, problem->help);
    if (const auto* culprit = llvm::dyn_cast_or_null<clang::NamedDecl>(problem->culprit)) {
      finding.notes.push_back({sourceOf(culprit), problem->help});
      finding.help.clear();
    }
    if (foreign && !problem->culprit) {
      finding.help = "leave it out: all(), member(" + declaration->getNameAsString() + ", skip())";
    }
    finding.fixes = fixesFor(declaration, *problem, *this);
    return std::nullopt;
  }
  // An event's values have lost the names that they were written with: std::int64_t is long here.
  const bool unnamed = foreign || isAnnotated(declaration, Kind::Event);
  const std::string integer = unnamed ? "" : platformInteger(type);
  if (!integer.empty()) {
    warn(declaration, "platform-integer",
         subject + " is a '" + integer + "', whose width differs between machines",
         "use std::int64_t or std::uint64_t, which is what the wire carries");
  }
  auto result = std::get<model::Type>(std::move(mapped));
  checkNumberArguments(declaration, subject, result, field);
  if (!applyCapacity(result, field.capacity)) {
    error(declaration, "capacity-levels",
          subject + " has more bounds in capacity() than strings and lists",
          "give one number for each string or list, outside in");
  }
  if (field.bulk && !makeBulk(result)) {
    error(declaration, "bulk-type",
          subject + " is bulk() but neither a list of numbers nor a large matrix",
          "drop it; bulk() is for vectors and arrays of numbers, and for matrices whose rows are "
          "open "
          "or that have more than 16 coefficients");
  }
  return result;
}

void Mapping::checkNumberArguments(const clang::NamedDecl* declaration, const std::string& subject,
                                   const model::Type& type, const Annotation& field) {
  if (!field.unit.empty() && !model::holdsQuantities(type)) {
    error(declaration, "not-a-number", subject + " has a unit() but holds no plain numbers",
          "drop it; durations and stamps carry their unit in their type");
  }
  if (field.range && !model::holdsNumbers(type)) {
    error(declaration, "not-a-number", subject + " has a range() but holds no plain numbers",
          "drop it");
  }
}

}  // namespace suture::compiler::frontend
