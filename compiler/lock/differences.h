#pragma once
// This tells two versions of a schema apart, and is the only place that judges an edit: a build,
// `--update-lock` and `suturec diff` say what stands here.

#include <string>
#include <vector>

#include "compiler/lock/schema/lock.h"

namespace suture::compiler::lock {

/// Says what peers of the two versions meet.
enum class Effect {
  None,      ///< they understand each other
  Refusals,  ///< they understand each other, and refuse some values
  Break      ///< they misread or miss something
};

/// Says what kind of thing an edit has changed.
enum class Change {
  New,
  Removed,
  Renamed,  ///< on the wire
  Moved,    ///< to or from another file, or something that the file names is elsewhere
  Kind,     ///< such as a struct that became an enum
  Type,
  Meaning,    ///< an annotation that says what bytes mean (kMeaningful)
  Limit,      ///< a range, a capacity, a fallback() that is gone, a set instead of a list
  Policy,     ///< any other annotation: a queue, `latest()`, the name in C++
  Default,    ///< in C++; the schema's own default never changes while the type stays
  Parameter,  ///< one is gone
  Base,
  Version,
  Identity  ///< a place, an id or a major is another, which no header can cause
};

/// Points to where a schema says it; both are null if it says nothing.
struct LockPlace {
  const Node* node = nullptr;
  const Member* member = nullptr;
};

/// Tells one edit. It points into both locks, which must outlive it.
struct Difference {
  Change change = Change::New;
  Effect effect = Effect::None;
  LockPlace before, now;
  std::string part;     ///< "'speed'" if a parameter or result differs, else ""
  std::string what;     ///< the annotation: "unit"
  std::string subject;  ///< "'x' of struct Pose"
  std::string detail;   ///< ": unit \"mm\" instead of \"m\"", or " is new"
  std::string hint;     ///< what to do if something else was meant

  /// Returns "'x' of struct Pose: unit \"mm\" instead of \"m\"".
  std::string text() const { return subject + detail + (hint.empty() ? "" : "; " + hint); }
  /// Returns what `suturec diff` and `--update-lock` print: "breaks:  " and the text.
  std::string line() const;
};

/// Returns the edits in the order of the old version's text, and behind them what is new. If there
/// is no old text, because all came from other files, that is all that it tells.
std::vector<Difference> differences(const Lock& old, const Lock& now);

}  // namespace suture::compiler::lock
