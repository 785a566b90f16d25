// Written by suturec from shapes/open.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. open.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slots.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "shapes/open.h"
#include "shapes/containers.suture.h"

namespace shapes {

struct RootSlot;
struct BranchSlot;

/// Holds itself, and another that holds it.
struct RootSlot {
  std::int32_t value;
  suture::OpenList<RootSlot> children;
  suture::OpenOptional<RootSlot> shadow;
  suture::OpenList<BranchSlot> branches;
};

bool store(const Root& value, RootSlot& slot);
void load(const RootSlot& slot, Root& value);

struct BranchSlot {
  double length;  // m
  suture::OpenList<suture::SlotEntry<suture::OpenText, RootSlot>> roots;
};

bool store(const Branch& value, BranchSlot& slot);
void load(const BranchSlot& slot, Branch& value);

/// Each level that may lack its bound, all of it or a part.
struct OpenSlot {
  suture::OpenText name;
  suture::OpenList<double> samples;
  suture::OpenList<std::uint8_t> bytes;
  suture::OpenList<float> block;
  suture::OpenList<std::uint8_t> flags;
  suture::OpenList<PointSlot> path;
  std::array<suture::OpenText, 2> pair;
  suture::BoundedList<suture::OpenText, 2> words;
  suture::OpenList<suture::BoundedText<3>> shorts;
  suture::OpenList<suture::OpenText> keys;
  suture::OpenList<suture::SlotEntry<suture::OpenText, suture::OpenList<PointSlot>>> series;
  suture::SlotOptional<suture::OpenText> note;
  suture::SlotVariant<suture::SlotNothing, suture::OpenText, PointSlot> either;
  suture::SlotTuple<std::int32_t, suture::OpenText> entry;
  suture::OpenList<double> joints;
  suture::OpenMatrix<double> any;                             // Eigen::MatrixXd
  suture::BoundedMatrix<double, 2, suture::kUnbounded> wide;  // Eigen::MatrixXd
  suture::OpenList<std::array<double, 3>> cloud;
  suture::OpenMatrix<double> image;  // Eigen::MatrixXd
  RootSlot root;
};

bool store(const Open& value, OpenSlot& slot);
void load(const OpenSlot& slot, Open& value);
void reserve(const OpenSlot*, Open& value);

bool isValid(const RootSlot& slot, suture::FieldPath* path);
bool isValid(const BranchSlot& slot, suture::FieldPath* path);
bool isValid(const OpenSlot& slot, suture::FieldPath* path);

// --- Archive: the arguments of its commands ---

struct ArchivePutArguments {
  suture::OpenText key;
  OpenSlot value;
};

bool store(const std::string& key, const Open& value, ArchivePutArguments& slot);

struct ArchiveRemarkArguments {
  suture::OpenText text;
};

bool store(const std::string& text, ArchiveRemarkArguments& slot);

struct ArchiveFindArguments {
  suture::OpenText pattern;
};

bool store(const std::string& pattern, ArchiveFindArguments& slot);

struct ArchiveReplaceArguments {
  OpenSlot value;
};

bool store(const Open& value, ArchiveReplaceArguments& slot);

// --- Archive: what its events carry ---

struct ArchiveGrownPayload {
  suture::OpenText value;
  RootSlot value2;
};

bool store(const std::string& value, const Root& value2, ArchiveGrownPayload& slot);
void load(const ArchiveGrownPayload& slot, std::string& value, Root& value2);

/// Numbers the commands of Archive.
struct ArchiveCommand {
  static constexpr std::uint16_t put = 0;
  static constexpr std::uint16_t remark = 1;
  static constexpr std::uint16_t newest = 2;
  static constexpr std::uint16_t find = 3;
  static constexpr std::uint16_t replace = 4;
};

/// Numbers the events of Archive.
struct ArchiveEvent {
  static constexpr std::uint16_t renamed = 0;
  static constexpr std::uint16_t grown = 1;
  static constexpr std::uint16_t changed = 2;
};

/// Numbers the reads of Archive as a row of the state has them.
struct ArchiveColumn {
  static constexpr std::uint16_t newest = 0;
};

}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const shapes::Root& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Root& value);

template <>
Result<std::vector<std::byte>> encode(const shapes::Branch& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Branch& value);

template <>
Result<std::vector<std::byte>> encode(const shapes::Open& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Open& value);

template <>
const InterfaceInfo& interfaceInfo<shapes::Archive>();

/// Calls shapes::Archive of another component.
template <>
class Required<shapes::Archive> : public RequiredBase {
  using Contract = shapes::Archive;
  using Id = shapes::ArchiveCommand;
  using EventId = shapes::ArchiveEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Keeps `value` under `key`.
  /// Write: up to 16 wait.
  Command<&Contract::put, shapes::ArchivePutArguments> put{*this, Id::put};
  /// Write: a newer one replaces the one that waits.
  Command<&Contract::remark, shapes::ArchiveRemarkArguments> remark{*this, Id::remark};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::newest, shapes::OpenSlot> newest{*this, Id::newest};
  /// Qualified read: asked in the component's thread. `within()` waits 1 s for the answer.
  QualifiedReadCommand<&Contract::find, shapes::ArchiveFindArguments,
                       suture::OpenList<suture::OpenText>> find{*this, Id::find};
  /// Write with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::replace, shapes::ArchiveReplaceArguments, shapes::OpenSlot> replace{
      *this, Id::replace};

  /// Subscribes to the events of shapes::Archive.
  struct Events {
    explicit Events(RequiredBase& required)
        : renamed{required, EventId::renamed},
          grown{required, EventId::grown},
          changed{required, EventId::changed} {}

    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<suture::OpenText, std::string> renamed;
    /// At a subscriber up to 16 wait.
    Subscription<shapes::ArchiveGrownPayload, std::string, shapes::Root> grown;
    /// At a subscriber a newer one replaces the one that waits.
    Subscription<shapes::OpenSlot, shapes::Open> changed;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves shapes::Archive from a component.
template <>
class Provided<shapes::Archive> : public ProvidedBase {
  using Contract = shapes::Archive;
  using EventId = shapes::ArchiveEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of shapes::Archive.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : renamed{provided, EventId::renamed},
          grown{provided, EventId::grown},
          changed{provided, EventId::changed} {}

    Emitter<suture::OpenText, std::string> renamed;
    Emitter<shapes::ArchiveGrownPayload, std::string, shapes::Root> grown;
    Emitter<shapes::OpenSlot, shapes::Open> changed;
  };
  Events& emit() { return events_; }

 protected:
  // For contracts that derive from this one: `whole` points to their implementation.
  Provided(Component& owner, std::string_view name, const InterfaceInfo& info, void* whole,
           Contract& implementation)
      : ProvidedBase(owner, name, info, whole),
        implementation_(implementation) {}

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

 private:
  struct Dispatch;  // has a function for each command

  // Reused by every command, so that what they own is allocated once: by reserved().
  struct Scratch {
    std::string put_key{};
    shapes::Open put_value{};
    std::string remark_text{};
    std::string find_pattern{};
    shapes::Open replace_value{};

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
