#include <suture/base/errors.h>
#include <suture/lane/shm/shared_memory.h>
#include <suture/loop/failure.h>

namespace suture::shm {
namespace {

// These bound the state table that a provider in another process lets us map.
constexpr std::size_t kMostStateBytes = std::size_t{1} << 30;
constexpr std::uint32_t kMostRows = 1u << 20;
constexpr unsigned kMostColumns = 64;

class MemoryServer final : public wire::SharedMemory::Server {
 public:
  explicit MemoryServer(std::shared_ptr<MemoryBlock> block) : block_(std::move(block)) {}
  kj::Maybe<int> getFd() override { return block_->descriptor(); }

 private:
  const std::shared_ptr<MemoryBlock> block_;
};

kj::Exception noMemory(const std::string& text) {
  return loop::failure(kj::Exception::Type::FAILED, text);
}

kj::Promise<shm::SharedParts> receiveBlocks(wire::SharedChannel::Reader in,
                                            const InterfaceInfo& contract, shm::SharedParts parts) {
  using Others = MemoryBlock::Others;
  const std::size_t stateBytes = shm::stateBytes(parts);
  if (stateBytes > kMostStateBytes) return noMemory("the provider keeps too many rows to map");
  auto promise = receive(in.getChannel(), shm::channelBytes(contract), Others::Write);
  return promise.then([bell = in.getBell(), state = in.getState(), stateBytes,
                       parts = std::move(parts)](std::shared_ptr<MemoryBlock> channel) mutable {
    parts.channel = std::move(channel);
    return receive(kj::mv(state), stateBytes, Others::Read)
        .then([bell = kj::mv(bell),
               parts = std::move(parts)](std::shared_ptr<MemoryBlock> table) mutable {
          parts.state = std::move(table);
          return receive(kj::mv(bell), sizeof(std::uint64_t), Others::Write)
              .then([parts = std::move(parts)](std::shared_ptr<MemoryBlock> word) mutable {
                parts.bell = std::move(word);
                return std::move(parts);
              });
        });
  });
}

}  // namespace

wire::SharedMemory::Client handOut(std::shared_ptr<MemoryBlock> block) {
  return kj::heap<MemoryServer>(std::move(block));
}

kj::Promise<std::shared_ptr<MemoryBlock>> receive(wire::SharedMemory::Client memory,
                                                  std::size_t size, MemoryBlock::Others others) {
  return memory.getFd().then(
      [memory, size,
       others](kj::Maybe<int> descriptor) -> kj::Promise<std::shared_ptr<MemoryBlock>> {
        KJ_IF_MAYBE (handle, descriptor) {
          try {
            return MemoryBlock::open(*handle, size, others);
          } catch (const SetupError& error) {
            return noMemory(error.what());
          }
        }
        return noMemory("no descriptor came with the memory");
      });
}

void toWire(const shm::SharedParts& parts, wire::SharedChannel::Builder out) {
  out.setChannel(handOut(parts.channel));
  out.setState(handOut(parts.state));
  out.setBell(handOut(parts.bell));
  out.setRows(parts.rows);
  auto columns = out.initColumns(static_cast<unsigned>(parts.columns.size()));
  for (unsigned i = 0; i < parts.columns.size(); ++i) columns.set(i, parts.columns[i]);
}

kj::Promise<shm::SharedParts> receive(wire::SharedChannel::Reader in,
                                      const InterfaceInfo& contract) {
  shm::SharedParts parts;
  parts.rows = in.getRows();
  if (parts.rows > kMostRows || in.getColumns().size() > kMostColumns) {
    return noMemory("the provider's state table has an impossible form");
  }
  for (const std::uint32_t size : in.getColumns()) parts.columns.push_back(size);
  return receiveBlocks(in, contract, std::move(parts));
}

}  // namespace suture::shm
