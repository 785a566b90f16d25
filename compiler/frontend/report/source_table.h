#pragma once
// This knows where the declarations of the model stand: it turns clang locations into model::Source
// and back.

#include <clang/Basic/SourceLocation.h>
#include <clang/Basic/SourceManager.h>

#include <string>
#include <vector>

#include "compiler/model/type.h"

namespace suture::compiler::frontend {

class SourceTable {
 public:
  struct Place {
    clang::SourceLocation caret;
    clang::SourceRange range;
  };

  model::Source add(const clang::SourceManager& sources, clang::SourceLocation caret,
                    clang::SourceRange range) {
    places_.push_back({caret, range});
    const clang::PresumedLoc presumed = sources.getPresumedLoc(sources.getExpansionLoc(caret));
    return {.handle = static_cast<std::uint32_t>(places_.size()),
            .file = presumed.isValid() ? presumed.getFilename() : "",
            .line = presumed.isValid() ? presumed.getLine() : 0};
  }

  /// Returns the place of a source, or null if the source did not come from here.
  const Place* find(const model::Source& source) const {
    return source.handle == 0 || source.handle > places_.size() ? nullptr
                                                                : &places_[source.handle - 1];
  }

 private:
  std::vector<Place> places_;
};

}  // namespace suture::compiler::frontend
