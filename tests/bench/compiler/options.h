#pragma once
// A user may choose these for `suture-bench compiler`.

#include <CLI/CLI.hpp>
#include <cstddef>
#include <filesystem>
#include <string>

namespace bench {

struct CompilerOptions {
  std::size_t rounds = 9;  ///< programs of about a second run so often, compilers a third of it
  int cpu;                 ///< that all programs run on
  std::string part;        ///< the only one to measure; "": all, as a check needs it
  bool quick = false;      ///< one round of everything
  std::filesystem::path scratch;  ///< an empty folder, for this run alone

  std::size_t toolRounds() const { return quick ? 1 : rounds; }
  std::size_t compileRounds() const { return quick ? 1 : (rounds + 2) / 3; }
  std::size_t codecLoops() const { return quick ? 10 : 200; }
};

}  // namespace bench
