#pragma once
// These provide large values, and require them.

#include <suture/component/device.h>
#include <suture/component/task/periodic_task.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "support/allocations.h"
#include "unit/large_values/picture.suture.h"

namespace large_values {

inline constexpr std::size_t kPixels = 1 << 20;

inline Picture grey(std::uint8_t value) { return {std::vector<std::uint8_t>(kPixels, value)}; }

/// Both kinds of provider have this in common.
struct Wall : Gallery {
  const Picture& newest() const override { return newest_; }
  const Picture& oldest() const override { return oldest_; }
  Picture dimmed(const Picture& picture) const override {
    const auto shade = static_cast<std::uint8_t>(picture.pixels.front() / 2);
    return {std::vector<std::uint8_t>(picture.pixels.size(), shade)};
  }
  void hang(const Picture& picture) override { newest_ = picture; }

  Picture newest_ = grey(9), oldest_ = grey(3);
};

struct WallDevice final : suture::Device, Wall {
  suture::Provided<Gallery> gallery{*this, "Gallery", *this};
};

struct WallTask : suture::PeriodicTask, Wall {
  WallTask() : PeriodicTask({.period = std::chrono::milliseconds(1)}) {}
  ~WallTask() override { stop(); }
  /// Counts what the first emission takes from the heap.
  void run() override {
    if (firstEmission) return;
    const auto before = suture::allocations();
    const auto emitted = gallery.emit().hung(oldest_);
    firstEmission = emitted ? suture::allocations() - before : ~std::uint64_t{0};
    emittedOnce.store(true, std::memory_order_release);
  }

  std::optional<std::uint64_t> firstEmission;
  std::atomic<bool> emittedOnce{false};
  suture::Provided<Gallery> gallery{*this, "Gallery", *this};
};

struct Visitor final : suture::Device {
  Visitor() {
    gallery.on().hung([this](const Picture& picture) {
      size = picture.pixels.size();
      heard = size == 0 ? 0 : picture.pixels.front();
    });
  }
  suture::Required<Gallery> gallery{*this, "Gallery"};
  std::size_t size = 0;
  int heard = 0;  // its shade
};

}  // namespace large_values
