#pragma once
// Tests of a deployment file change one piece of a sound one.

#include <gtest/gtest.h>
#include <suture/deploy/document/deployment.h>

#include <string>
#include <string_view>
#include <vector>

namespace suture::sound {

inline constexpr const char* kSound = R"({
  "manager": "unix:/tmp/suture.sock",
  "processes": [
    {
      "name": "left",
      "components": [
        {"name": "MTML", "class": "Mtm"},
        {"name": "Teleop", "class": "Teleop", "parameters": {"scale": 0.2}}
      ]
    },
    {
      "name": "right",
      "components": [{"name": "PSM1", "class": "Psm"}]
    }
  ],
  "connections": [
    {"from": "left:Teleop/Master", "to": "left:MTML/Arm"},
    {"from": "left:Teleop/Slave", "to": "right:PSM1/Arm", "lane": "rpc"}
  ]
})";

/// Returns kSound with one piece replaced.
inline std::string with(std::string_view piece, std::string_view replacement) {
  std::string text = kSound;
  const std::size_t at = text.find(piece);
  EXPECT_NE(at, std::string::npos) << piece;
  return text.replace(at, piece.size(), replacement);
}

/// Returns what is wrong with a deployment; nothing if it is sound.
inline std::vector<std::string> problemsOf(const std::string& text) {
  try {
    Deployment(JsonDocument::parse(text, "d.json"));
  } catch (const DocumentError& error) {
    return error.problems();
  }
  return {};
}

inline void expectOnly(const std::string& text, const std::string& problem) {
  EXPECT_EQ(problemsOf(text), std::vector<std::string>{problem});
}

}  // namespace suture::sound
