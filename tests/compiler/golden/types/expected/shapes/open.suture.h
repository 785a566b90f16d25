// Written by suturec from shapes/open.h. Do not edit.
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

/// Names the numbers of Archive's commands in every table and record.
enum class ArchiveCommand : std::uint16_t {
  put,
  remark,
  newest,
  find,
  replace,
};

/// Names the numbers of Archive's events.
enum class ArchiveEvent : std::uint16_t {
  renamed,
  grown,
  changed,
};

/// Names where a row of the state has each read of Archive.
enum class ArchiveColumn : std::uint16_t {
  newest,
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
  Command<&Contract::put, shapes::ArchivePutArguments> put{
      *this, static_cast<std::uint16_t>(Id::put)};
  Command<&Contract::remark, shapes::ArchiveRemarkArguments> remark{
      *this, static_cast<std::uint16_t>(Id::remark)};
  ReadCommand<&Contract::newest, shapes::OpenSlot> newest{
      *this, static_cast<std::uint16_t>(Id::newest)};
  QualifiedReadCommand<&Contract::find, shapes::ArchiveFindArguments,
                       suture::OpenList<suture::OpenText>> find{
      *this, static_cast<std::uint16_t>(Id::find)};
  ReturningCommand<&Contract::replace, shapes::ArchiveReplaceArguments, shapes::OpenSlot> replace{
      *this, static_cast<std::uint16_t>(Id::replace)};

  /// Subscribes to the events of shapes::Archive.
  struct Events {
    explicit Events(RequiredBase& required)
        : renamed{required, static_cast<std::uint16_t>(EventId::renamed)},
          grown{required, static_cast<std::uint16_t>(EventId::grown)},
          changed{required, static_cast<std::uint16_t>(EventId::changed)} {}

    Subscription<suture::OpenText, std::string> renamed;
    Subscription<shapes::ArchiveGrownPayload, std::string, shapes::Root> grown;
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
        : renamed{provided, static_cast<std::uint16_t>(EventId::renamed)},
          grown{provided, static_cast<std::uint16_t>(EventId::grown)},
          changed{provided, static_cast<std::uint16_t>(EventId::changed)} {}

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
