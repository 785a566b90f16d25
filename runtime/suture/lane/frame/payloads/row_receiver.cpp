#include <suture/base/words.h>
#include <suture/lane/frame/payloads/row_receiver.h>

#include <algorithm>
#include <cstring>

namespace suture::frame {

RowReceiver::RowReceiver(const InterfaceInfo& contract) {
  for (const CommandInfo& one : contract.commands) {
    if (one.column >= 0) columns_.push_back({&one});
  }
  values_.resize(columns_.size());
}

bool RowReceiver::begin(std::span<const std::byte> payload) {
  if (payload.size() < sizeof(row_)) return false;
  std::memcpy(&row_, payload.data(), sizeof(row_));
  std::ranges::fill(values_, rt::StateTable::Value{});
  begun_ = true;
  column_ = 0;
  place_ = sizeof(row_);
  come_ = taken_ = 0;
  reader_.reset();
  return true;
}

// Goes on with the column that arrives; returns true if all have.
bool RowReceiver::advance(std::span<const std::byte> payload) {
  for (; column_ < columns_.size(); ++column_) {
    if (!row_.hasValue(static_cast<unsigned>(column_))) continue;
    if (place_ > payload.size()) return false;
    Column& column = columns_[column_];
    column.begin = place_;
    if (!takeValue(column, payload.subspan(place_))) return false;
    place_ += wordBytes(taken_);
    come_ = taken_ = 0;
  }
  return true;
}

bool RowReceiver::takeValue(Column& column, std::span<const std::byte> come) {
  if (!column.read->resultLevels.empty()) return takeUsed(column, come);
  const std::size_t size = column.read->resultSize;
  come_ = taken_ = std::min(size, come.size());
  return come_ == size;
}

bool RowReceiver::takeUsed(Column& column, std::span<const std::byte> come) {
  const CommandInfo& read = *column.read;
  if (column.slot == nullptr) column.slot = std::make_unique<std::byte[]>(read.resultSize);
  if (!reader_) reader_.emplace(column.slot.get(), read.resultSize, read.resultLevels);
  taken_ = come.size() - reader_->take(come.subspan(taken_)).size();
  const bool done = reader_->done();
  come_ = done ? read.resultSize : wordBefore(reader_->place());
  if (done) reader_.reset();
  return done;
}

// A column whose stamps must be shifted is stored when it is complete.
void RowReceiver::part(std::span<std::byte> payload, Duration shift, rt::StateTable& mirror) {
  if (!begun_ && !begin(payload)) return;
  const std::size_t before = column_;
  const bool all = advance(payload);
  const std::size_t last = all ? columns_.size() : column_ + 1;
  for (std::size_t i = before; i < last; ++i) {
    const auto number = static_cast<unsigned>(i);
    const std::size_t come = i < column_ ? columns_[i].read->resultSize : come_;
    if (!row_.hasValue(number) || come == 0 || turns(columns_[i].read->shiftResult, shift))
      continue;
    std::byte* const slot = columns_[i].slot.get();
    values_[i].bytes = slot != nullptr ? slot : payload.data() + columns_[i].begin;
    mirror.storeAhead(number, values_[i], come);
  }
}

std::optional<ArrivedRow> RowReceiver::whole(std::span<std::byte> payload, Duration shift) {
  if (!begun_ && !begin(payload)) return std::nullopt;
  begun_ = false;
  if (!advance(payload) || place_ != payload.size()) return std::nullopt;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (!row_.hasValue(static_cast<unsigned>(i))) continue;
    const Column& column = columns_[i];
    std::byte* const value =
        column.slot != nullptr ? column.slot.get() : payload.data() + column.begin;
    values_[i].bytes = value;
    if (!turns(column.read->shiftResult, shift)) continue;
    values_[i].stored = 0;
    column.read->shiftResult(value, shift);
  }
  return ArrivedRow{row_, values_};
}

}  // namespace suture::frame
