#include <suture/component/channel/channel.h>
#include <suture/component/component.h>
#include <suture/component/provided/row_publisher.h>

#include <string>

namespace suture {

void RowPublisher::keep(const StateOptions& options) {
  const std::string asked = "the state table of '" + clients_.name() + "'";
  if (!clients_.channels().empty() || demand() != 0) {
    throw SetupError(asked, "somebody uses it already",
                     "Call keepState() in the component's constructor");
  }
  if (options.manual && !clients_.owner().ownsThread()) {
    throw SetupError(asked, "a device, which has no thread to publish rows in",
                     "Make the component a task, or leave 'manual' out");
  }
  if (options.rows < 2 || options.rows > StateOptions::kMostRows) {  // one is mostly being written
    throw SetupError(asked, std::to_string(options.rows) + " rows",
                     "Keep 2 to " + std::to_string(StateOptions::kMostRows));
  }
  options_ = options;
  if (rt::StateTable* const table = usable_.load(std::memory_order_acquire); table != nullptr) {
    table->resize(options.rows);
  }
}

const std::shared_ptr<rt::StateTable>& RowPublisher::table() {
  std::call_once(made_, [this] {
    table_ = makeStateTable(clients_.info(), rt::StateTable::Readers::Elsewhere, options_.rows);
    usable_.store(table_.get(), std::memory_order_release);
  });
  return table_;
}

rt::ColumnSet RowPublisher::demand() const {
  const rt::StateTable* const table = usable_.load(std::memory_order_acquire);
  return table == nullptr ? 0 : table->demand();
}

void RowPublisher::publish() {
  const rt::ColumnSet wanted = demand();
  if (wanted == 0) return;
  rt::StateTable& table = *usable_.load(std::memory_order_relaxed);
  const auto& commands = clients_.info().commands;
  rt::RowColumns columns;
  for (std::uint16_t i = 0; i < commands.size(); ++i) {
    const int column = commands[i].column;
    if (column < 0 || (wanted >> column & 1) == 0) continue;
    const auto number = static_cast<unsigned>(column);
    columns.enter(number, produce(runner_, clients_, i, nullptr, table.draft(number), nullptr));
  }
  table.publish(now(), columns);
  clients_.channels().forEach([this](ChannelList::Node& node) {
    if (node.channel->provider.rowsAreWanted()) {
      clients_.owner().ringLater(*node.channel->ends.client);
    }
  });
}

}  // namespace suture
