#include <suture/base/words.h>
#include <suture/component/channel/channel.h>
#include <suture/record/state_collector.h>
#include <suture/rt/period.h>
#include <suture/rt/state/state_table.h>

#include <algorithm>

namespace suture {

/// A Source is what the collector looks at, of any contract.
class StateCollector::Source final : public RequiredBase {
 public:
  Source(Component& owner, const InterfaceInfo& contract)
      : RequiredBase(owner, "Source", contract) {
    needRows();
  }

  /// Returns the provider's state; nullptr while nothing reaches it.
  std::shared_ptr<rt::StateTable> state() {
    return unusable() == Errc{} ? channel()->state : nullptr;
  }
  /// Returns true if `table` belongs to the connection of this cycle, though it may be lost.
  bool has(const std::shared_ptr<rt::StateTable>& table) const {
    return channel() != nullptr && channel()->state == table;
  }
  /// Call this only with a connection. Asks that its rows from now on hold the reads `wanted`.
  void ask(const std::vector<std::uint16_t>& wanted) {
    rt::ColumnSet columns = 0;
    for (const std::uint16_t read : wanted) {
      if (unusable(read) != Errc{}) continue;
      columns |= rt::ColumnSet{1} << info().commands[read].column;
    }
    if (channel()->state->askAll(columns)) owner().ringLater(*channel()->ends.provider);
  }
  /// Returns false for a copy out of `table` that the contract does not admit, because another
  /// process may have written it.
  bool admits(std::uint16_t read, const std::byte* copy,
              const std::shared_ptr<rt::StateTable>& table) const {
    const CommandInfo& command = info().commands[read];
    return has(table) ? channel()->admitsCopy(command, copy) : command.admitsResult(copy);
  }
};

StateCollector::StateCollector(const InterfaceInfo& contract, const StateCollectorOptions& options,
                               Sink& sink)
    : EventTask({.scheduling = options.scheduling,
                 .longestSleep = rt::positivePeriod("a collector", options.period)}),
      reads_(readsOf(contract, options.reads)),
      collection_(options.interval, options.collecting),
      sink_(sink),
      source_(std::make_unique<Source>(*this, contract)),
      from_{"", contract} {
  for (const CommandInfo& command : contract.commands) {
    if (command.kind == CommandKind::Read) slots_.push_back(nullptr);
  }
  for (const std::uint16_t read : reads_) {
    const CommandInfo& command = contract.commands[read];
    memory_.emplace_back(wordsFor(command.resultSize));
    slots_[static_cast<std::size_t>(command.column)] =
        reinterpret_cast<std::byte*>(memory_.back().data());
    values_.push_back({read, nullptr});
  }
}

StateCollector::StateCollector(const InterfaceInfo& contract, const StateCollectorOptions& options,
                               std::shared_ptr<Sink> sink)
    : StateCollector(contract, options, *sink) {
  ownSink_ = std::move(sink);
}

StateCollector::~StateCollector() { stop(); }

void StateCollector::startCollecting() {
  collection_.switchTo(true);
  doorbell().ring();
}

void StateCollector::stopCollecting() {
  collection_.switchTo(false);
  doorbell().ring();
}

void StateCollector::run() {
  const bool wanted = collection_.wanted();
  if (!wanted && !collection_.active()) return;
  if (table_ != nullptr && !source_->has(table_)) {  // its connection is gone
    takeRows();
    table_ = nullptr;
  }
  const auto table = source_->state();
  if (table != nullptr && (table != table_ || !collection_.active())) {
    table_ = table;
    begin();
  }
  if (table_ != nullptr) takeRows();
  if (!wanted) {
    collection_.setActive(false);
    table_ = nullptr;
  }
}

void StateCollector::onStart() {
  from_.collector = name();
  collection_.settle(sink_, from_, unreported_);
}

// Takes the rows that are left at the end.
void StateCollector::onStop() { run(); }

// A connection that was made anew has a table of its own, while the counts go on. Fix the row to
// take before asking, because asking may bring about the first row at once.
void StateCollector::begin() {
  next_ = table_->rows() + 1;
  source_->ask(reads_);
  if (!collection_.active()) collection_.setActive(true);
}

// Takes the rows that are there now. Those that come meanwhile have to wait for the next look,
// since with a sink that is slower than the provider this would never end.
void StateCollector::takeRows() {
  const std::uint64_t newest = table_->rows();
  while (next_ <= newest) {
    const rt::StateTable::Row row = table_->readRowNumber(next_, slots_);
    if (row.sequence != 0) {
      passToSink(next_, row.stamp, row.valid);
      ++next_;
      continue;
    }
    // The row is overwritten, and so are all rows that are more than one lap behind the writer.
    const std::uint64_t present = table_->rows(), capacity = table_->capacity();
    const std::uint64_t oldest = present >= capacity ? present - capacity + 1 : 1;
    const std::uint64_t resume = std::max(next_ + 1, oldest);
    countMissed(resume - next_);
    next_ = resume;
  }
  if (unreported_ > 0) sink_.missed(from_, std::exchange(unreported_, 0));
  collection_.settle(sink_, from_, unreported_);
}

void StateCollector::passToSink(std::uint64_t number, Time stamp, std::uint64_t valid) {
  if (!collection_.keep(stamp)) return;
  if (unreported_ > 0) sink_.missed(from_, std::exchange(unreported_, 0));
  for (CollectedValue& value : values_) {
    const auto column = static_cast<std::size_t>(from_.contract.commands[value.read].column);
    const bool produced = (valid >> column & 1) != 0;
    const bool admitted = produced && source_->admits(value.read, slots_[column], table_);
    value.slot = admitted ? slots_[column] : nullptr;
  }
  sink_.row(from_, number, stamp, values_);
}

void StateCollector::countMissed(std::uint64_t rows) {
  collection_.countMissed(rows);
  unreported_ += rows;
}

}  // namespace suture
