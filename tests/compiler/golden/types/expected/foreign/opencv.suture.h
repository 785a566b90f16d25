// Written by suturec from foreign/opencv.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. opencv.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "foreign/opencv.h"

namespace foreign {

struct cvPoint3dSlot {
  double x;
  double y;
  double z;
};

bool store(const cv::Point3d& value, cvPoint3dSlot& slot);
void load(const cvPoint3dSlot& slot, cv::Point3d& value);

struct cvMatx33dSlot {
  std::array<double, 9> val;
};

bool store(const cv::Matx33d& value, cvMatx33dSlot& slot);
void load(const cvMatx33dSlot& slot, cv::Matx33d& value);

/// A camera and what it sees.
struct ViewSlot {
  cvMatx33dSlot intrinsics;
  suture::BoundedList<cvPoint3dSlot, 4> points;
};

bool store(const View& value, ViewSlot& slot);
void load(const ViewSlot& slot, View& value);
void reserve(const ViewSlot*, View& value);

bool isValid(const cvPoint3dSlot& slot, suture::FieldPath* path);
bool isValid(const cvMatx33dSlot& slot, suture::FieldPath* path);
bool isValid(const ViewSlot& slot, suture::FieldPath* path);

// --- Camera: the arguments of its commands ---

struct CameraAimArguments {
  cvPoint3dSlot at;
};

bool store(const cv::Point3d& at, CameraAimArguments& slot);

/// Numbers the commands of Camera.
struct CameraCommand {
  static constexpr std::uint16_t aim = 0;
  static constexpr std::uint16_t view = 1;
};

/// Numbers the reads of Camera as a row of the state has them.
struct CameraColumn {
  static constexpr std::uint16_t view = 0;
};

}  // namespace foreign

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const cv::Point3d& value);
template <>
Result<> decode(std::span<const std::byte> bytes, cv::Point3d& value);

template <>
Result<std::vector<std::byte>> encode(const cv::Matx33d& value);
template <>
Result<> decode(std::span<const std::byte> bytes, cv::Matx33d& value);

template <>
Result<std::vector<std::byte>> encode(const foreign::View& value);
template <>
Result<> decode(std::span<const std::byte> bytes, foreign::View& value);

template <>
const InterfaceInfo& interfaceInfo<foreign::Camera>();

/// Calls foreign::Camera of another component.
template <>
class Required<foreign::Camera> : public RequiredBase {
  using Contract = foreign::Camera;
  using Id = foreign::CameraCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Write: up to 16 wait.
  Command<&Contract::aim, foreign::CameraAimArguments> aim{*this, Id::aim};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::view, foreign::ViewSlot> view{*this, Id::view};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
};

/// Serves foreign::Camera from a component.
template <>
class Provided<foreign::Camera> : public ProvidedBase {
  using Contract = foreign::Camera;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

 protected:
  // For contracts that derive from this one: `whole` points to their implementation.
  Provided(Component& owner, std::string_view name, const InterfaceInfo& info, void* whole,
           Contract& implementation)
      : ProvidedBase(owner, name, info, whole),
        implementation_(implementation) {}

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

 private:
  struct Dispatch;  // has a function for each command

  // Reused by every command, so that what they own is allocated once.
  struct Scratch {
    cv::Point3d aim_at{};
  };

  Contract& implementation_;
  Scratch scratch_;
};

}  // namespace suture
