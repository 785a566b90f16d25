#pragma once
// This is Table 2 of the paper beside what this run measured.

#include <suture/observe/report.h>

#include <string>
#include <vector>

#include "run/plan.h"
#include "tables/table.h"

namespace demo {

/// Shows the paper's loops, and below them ages of this run, which are of one way: those of the
/// connection to an arm that had the most ages, and enough of them, within a process and between
/// two. It does not claim that the two are comparable, because they are not.
class PaperTable {
 public:
  PaperTable(const Plan& plan, const std::vector<suture::ConnectionReport>& connections);

  const Table& table() const { return table_; }
  /// Returns what a reader has to know about it, line by line.
  const std::vector<std::string>& notes() const { return notes_; }
  /// Returns the figures of this run: "command_age", "read_age".
  const nlohmann::json& figures() const { return figures_; }

 private:
  using Age = suture::Distribution suture::ConnectionReport::*;

  void addAge(const char* title, const char* key, Age age);
  const suture::ConnectionReport* busiest(Age age, bool isLocal) const;

  std::vector<suture::ConnectionReport> toArms_;
  Table table_;
  std::vector<std::string> notes_;
  nlohmann::json figures_;
};

}  // namespace demo
