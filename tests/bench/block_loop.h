#pragma once
// These are the contracts of `suture-bench network --part sizes`: they carry the same bytes in
// types with little and with much room.

#include <suture/annotate.h>

#include <cstdint>
#include <vector>

namespace bench {

/// As large as a pose.
struct SUTURE_TYPE() SmallBlock {
  SUTURE_FIELD(capacity(120)) std::vector<std::uint8_t> bytes;
};

/// As large as an image at most.
struct SUTURE_TYPE() LargeBlock {
  SUTURE_FIELD(capacity(1048576)) std::vector<std::uint8_t> bytes;
};

class SUTURE_INTERFACE() SmallBlocks {
 public:
  using Block = SmallBlock;
  virtual ~SmallBlocks() = default;
  /// Client, server, client: sends the block back as the event echo.
  SUTURE_COMMAND(queue(2)) virtual void bounce(const SmallBlock& block) = 0;
  SUTURE_EVENT(queue(2)) suture::EventOf<SmallBlock> echo;
};

class SUTURE_INTERFACE() LargeBlocks {
 public:
  using Block = LargeBlock;
  virtual ~LargeBlocks() = default;
  /// Client, server, client: sends the block back as the event echo.
  SUTURE_COMMAND(queue(2)) virtual void bounce(const LargeBlock& block) = 0;
  SUTURE_EVENT(queue(2)) suture::EventOf<LargeBlock> echo;
};

}  // namespace bench
