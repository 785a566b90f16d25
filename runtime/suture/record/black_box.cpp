#include <suture/base/words.h>
#include <suture/component/provided.h>
#include <suture/record/black_box.h>
#include <suture/record/json_lines.h>
#include <suture/rt/period.h>
#include <suture/rt/state/state_table.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

namespace suture {
namespace {

/// Holds the reads of one provided interface, with memory for a row of them. Values that live on
/// the heap have no history, so they are left out.
class Rows {
 public:
  explicit Rows(ProvidedBase& provided)
      : table_(*provided.state()),
        from_{provided.owner().name() + "/" + provided.name(), provided.info()},
        slots_(table_.columns()) {
    for (std::uint16_t read = 0; read < provided.info().commands.size(); ++read) {
      const int column = provided.info().commands[read].column;
      if (column < 0 || table_.isShared(static_cast<unsigned>(column))) continue;
      memory_.emplace_back(wordsFor(table_.columnSize(static_cast<unsigned>(column))));
      slots_[static_cast<std::size_t>(column)] =
          reinterpret_cast<std::byte*>(memory_.back().data());
      values_.push_back({read, nullptr});
    }
  }

  void write(Time since, Sink& sink) {
    const std::uint64_t newest = table_.rows(), capacity = table_.capacity();
    for (std::uint64_t number = newest > capacity ? newest - capacity + 1 : 1; number <= newest;
         ++number) {
      const rt::StateTable::Row row = table_.readRowNumber(number, slots_);
      if (row.sequence == 0 || row.stamp < since) continue;
      for (CollectedValue& value : values_) {
        const auto column = static_cast<unsigned>(from_.contract.commands[value.read].column);
        value.slot = row.missing(column) == Errc{} ? slots_[column] : nullptr;
      }
      sink.row(from_, number, row.stamp, values_);
    }
  }

 private:
  const rt::StateTable& table_;
  const CollectedInterface from_;
  std::vector<std::byte*> slots_;  // by column; nullptr: left out
  std::vector<std::vector<std::uint64_t>> memory_;
  std::vector<CollectedValue> values_;
};

BlackBoxOptions checked(BlackBoxOptions options) {
  if (options.rows > StateOptions::kMostRows) {
    throw SetupError("a black box", std::to_string(options.rows) + " rows",
                     "Keep at most " + std::to_string(StateOptions::kMostRows));
  }
  rt::positivePeriod("a black box", options.period);
  if (!options.tell) {
    options.tell = [](const std::string& text) {
      std::fprintf(stderr, "black box: %s\n", text.c_str());
    };
  }
  return options;
}

void keepAll(const Component& component, unsigned rows) {
  for (ProvidedBase* provided : component.provided()) {
    rt::StateTable& state = *provided->state();
    if (rows > state.capacity()) state.resize(rows);
    for (unsigned column = 0; column < state.columns(); ++column) state.ask(column);
  }
}

// A device has rows only while its executor serves clients of other processes.
bool keepsRows(const Component& component) {
  const auto& all = component.provided();
  return component.ownsThread() || std::any_of(all.begin(), all.end(), [](ProvidedBase* one) {
           return one->state()->rows() > 0;
         });
}

}  // namespace

BlackBox::BlackBox(const std::vector<Component*>& components, BlackBoxOptions options)
    : options_(checked(std::move(options))) {
  for (Component* component : components) {
    keepAll(*component, options_.rows);
    watched_.push_back({component, component->faults()});
  }
  thread_.start("black box", [this] { watch(); });
}

BlackBox::~BlackBox() {
  ending_.ring();
  thread_.join();
}

void BlackBox::watch() {
  bool last = false;
  while (!last) {
    last = ending_.waitUntil(fromNow(options_.period)) != rt::RungFor::Nothing;
    for (Watched& watched : watched_) look(watched);
  }
}

void BlackBox::look(Watched& watched) {
  const Component& component = *watched.component;
  const std::uint64_t last = component.faults();
  if (last == watched.faults) return;
  const std::uint64_t first = std::exchange(watched.faults, last) + 1;
  const std::string reason = component.fault();
  const auto file = options_.folder /
                    (options_.prefix + component.name() + "." + std::to_string(last) + ".jsonl");
  const std::string several =
      first == last ? ""
                    : " (faults " + std::to_string(first) + " to " + std::to_string(last) + ")";
  const std::string what = "component '" + component.name() + "' faulted" + several + ": " + reason;
  try {
    write(component, first, last, reason, file);
    options_.tell(what +
                  (keepsRows(component) ? ". Its last state is in "
                                        : ". It is a device, of which no rows are kept; the fault "
                                          "alone is in ") +
                  file.string());
  } catch (const std::exception& error) {
    // The part that was written would only take the room that the next file needs.
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    options_.tell(what + ". Its last state is not kept: " + error.what());
  }
}

void BlackBox::write(const Component& component, std::uint64_t first, std::uint64_t last,
                     const std::string& reason, const std::filesystem::path& file) const {
  JsonLines lines(file);
  lines.begin();
  lines.faults(component.name(), first, last, reason);
  const Time since = now() - options_.last;
  for (ProvidedBase* provided : component.provided()) Rows(*provided).write(since, lines);
  lines.flush();
}

}  // namespace suture
