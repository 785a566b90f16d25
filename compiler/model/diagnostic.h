#pragma once
// A diagnostic is what suturec finds wrong with a model. check/ and lock/ make diagnostics, and the
// frontend, which still has the source, prints them in clang's form with a caret and help.

#include <string>
#include <vector>

#include "compiler/model/type.h"

namespace suture::compiler::model {

struct Note {
  Source source;
  std::string text;
};

/// A change of the header after which the finding is gone.
struct Fix {
  enum class Place { Before, After, Instead };  ///< where `text` goes, seen from `source`

  Source source;
  Place place = Place::Before;
  std::string text;
};

struct Diagnostic {
  enum class Severity { Error, Warning };

  Source source;
  std::string slug;  ///< "pointer-field": printed as [suture-pointer-field]
  std::string
      message;       ///< what was found: "field 'p' has pointer type 'int *'; ownership is unknown"
  std::string help;  ///< how to mend it; printed as a note
  std::vector<Note> notes;
  Severity severity = Severity::Error;
  std::vector<Fix> fixes{};  ///< it takes all of them to mend the finding
};

using Diagnostics = std::vector<Diagnostic>;

}  // namespace suture::compiler::model
