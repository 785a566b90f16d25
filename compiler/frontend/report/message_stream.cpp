#include "compiler/frontend/report/message_stream.h"

#include <utility>

#include "compiler/frontend/ast/annotation.h"
#include "compiler/model/nearest.h"

namespace suture::compiler::frontend {
namespace {

constexpr llvm::StringLiteral kUnknownMember = "error: no member named '";

/// Tells if the line is about a class whose members are generated.
bool namesInterface(llvm::StringRef line, llvm::StringRef before) {
  const llvm::StringRef rest = line.split(before).second;
  return rest.starts_with("'suture::Required<") || rest.starts_with("'suture::Provided<");
}

}  // namespace

MessageStream::MessageStream(llvm::raw_ostream& out, std::string unitName)
    : raw_ostream(/*unbuffered=*/true),
      out_(out),
      includeLine_("In file included from " + std::move(unitName) + ":") {}

MessageStream::~MessageStream() {
  if (!pending_.empty()) out_ << pending_;
}

void MessageStream::write_impl(const char* text, std::size_t size) {
  pending_.append(text, size);
  std::size_t start = 0;
  for (std::size_t end; (end = pending_.find('\n', start)) != std::string::npos; start = end + 1) {
    forward(llvm::StringRef(pending_).slice(start, end + 1));
  }
  pending_.erase(0, start);
}

void MessageStream::forward(llvm::StringRef line) {
  if (line.starts_with(includeLine_)) return;
  line.consume_front("./");
  line = line.rtrim();
  const bool excerpt = line.ltrim(" 0123456789").starts_with("|");
  if (excerpt && withinVocabulary_) return;
  // Clang takes the class for broken then, so that it cannot be what an interface belongs to.
  if (!excerpt && line.contains("error: ")) {
    withinConsequence_ = saidGenerated_ && namesInterface(line, "for initialization of ");
  }
  if (withinConsequence_) return;
  withinVocabulary_ = line.contains(": note: expanded from macro 'SUTURE_");
  if (withinVocabulary_) return;
  const std::size_t unknown = line.find(kUnknownMember);
  if (unknown == llvm::StringRef::npos) {
    out_ << line << '\n';
    if (excerpt && line.contains('^')) out_ << std::exchange(advice_, "");
  } else {
    forwardUnknown(line.take_front(unknown), line.drop_front(unknown + kUnknownMember.size()));
  }
}

// Explains a member that clang misses in what no user has heard of: the namespace of the arguments
// of annotations, or the class that stands for an interface until it is generated.
void MessageStream::forwardUnknown(llvm::StringRef place, llvm::StringRef rest) {
  const auto [name, where] = rest.split('\'');
  if (namesInterface(where, " in ")) {
    saidGenerated_ = true;
    out_ << place << "error: '" << name << "' of" << where.drop_front(3)
         << " is generated only after this header is read [suture-generated-member]\n";
    advice_ = place.str() +
              "note: make no type of it here: give the call or event a handler, or declare a "
              "struct and define it in the source\n";
    return;
  }
  if (!where.starts_with(" in namespace 'suture::dsl'")) {
    out_ << place << kUnknownMember << rest << '\n';
    return;
  }
  out_ << place << "error: no annotation has an argument '" << name
       << "' [suture-unknown-argument]\n";
  const auto meant = model::nearest({name.data(), name.size()}, annotationArguments());
  advice_ = place.str() + "note: " +
            (meant ? "did you mean '" + std::string(*meant) + "'?"
                   : "docs/annotations.md lists the arguments of each annotation") +
            "\n";
}

}  // namespace suture::compiler::frontend
