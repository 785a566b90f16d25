#include "cli/text/screen.h"
#include <suture/loop/standard_streams.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace suture::cli {
namespace {

constexpr std::size_t kWidth = 100;

bool isScalar(const Json& value) { return !value.is_structured() || value.empty(); }

/// Returns as many digits of a real number as people read: "0.0935" of 0.09350000000000003.
std::string real(const Json& value) {
  const double number = value.get<double>();
  if (!std::isfinite(number)) return value.dump();
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", number);
  const std::string digits = text.data();
  return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

std::string scalar(const Json& value) {
  if (value.is_string()) return plain(value.get<std::string>());
  return value.is_number_float() ? real(value) : value.dump();
}

/// Quotes a text as JSON does, so that an empty one, or one with commas, can be seen.
std::string quoted(const Json& value) {
  return value.is_string() ? '"' + scalar(value) + '"' : scalar(value);
}

/// Reads "m00 ... m22, x, y, z": rotation and translation, or a square matrix of such names alone.
std::vector<std::vector<std::string>> matrixIn(const Json& value) {
  std::vector<std::vector<std::string>> rows;
  if (!value.is_object() || !value.contains("m00")) return rows;
  const std::size_t size = value.contains("m33") ? 4 : 3;
  const bool pose = value.contains("x");
  if (value.size() != size * size + (pose ? 3 : 0)) return rows;
  constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
  for (std::size_t r = 0; r < size; ++r) {
    std::vector<std::string> row;
    for (std::size_t c = 0; c < size; ++c) {
      const std::string name = "m" + std::to_string(r) + std::to_string(c);
      if (!value.contains(name)) return {};
      row.push_back(valueLine(value[name]));
    }
    if (pose && r < kAxes.size() && value.contains(kAxes[r])) {
      row.push_back("| " + valueLine(value[kAxes[r]]));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Returns the elements of a list, as many on a line as fit.
std::string wrapped(const Json& list, unsigned indent) {
  const std::string margin(indent, ' ');
  std::string text, line = margin;
  for (const Json& element : list) {
    const std::string one = quoted(element);
    if (line.size() > indent && line.size() + one.size() + 1 > kWidth) {
      text += line + "\n";
      line = margin;
    }
    line += (line.size() > indent ? " " : "") + one;
  }
  return text + line + "\n";
}

std::string members(const Json& value, unsigned indent) {
  const std::string margin(indent, ' ');
  std::size_t widest = 0;
  for (const auto& [key, member] : value.items()) widest = std::max(widest, plain(key).size());
  std::string text;
  for (const auto& [key, member] : value.items()) {
    const std::string label = plain(key), line = valueLine(member);
    if (isScalar(member) ||
        (matrixIn(member).empty() && indent + widest + 2 + line.size() <= kWidth)) {
      text += margin + label + std::string(widest - label.size() + 2, ' ') + line + "\n";
    } else {
      text += margin + label + "\n" + valueText(member, indent + 2);
    }
  }
  return text;
}

}  // namespace

std::string valueLine(const Json& value) {
  if (isScalar(value)) return scalar(value);
  std::string text;
  for (const auto& [key, member] : value.items()) {
    if (!text.empty()) text += ", ";
    if (value.is_object()) text += plain(key) + ": ";
    text += member.is_structured() ? valueLine(member) : quoted(member);
  }
  return value.is_object() ? "{" + text + "}" : "[" + text + "]";
}

std::string valueText(const Json& value, unsigned indent) {
  const std::string margin(indent, ' ');
  if (const auto rows = matrixIn(value); !rows.empty()) return columns(rows, indent);
  if (value.is_object() && !value.empty()) return members(value, indent);
  const std::string line = valueLine(value);
  if (isScalar(value) || indent + line.size() <= kWidth) return margin + line + "\n";
  if (std::all_of(value.begin(), value.end(), isScalar)) return wrapped(value, indent);
  std::string text;
  for (std::size_t i = 0; i < value.size(); ++i) {
    text += margin + "[" + std::to_string(i) + "]\n" + valueText(value[i], indent + 2);
  }
  return text;
}

std::string columns(const std::vector<std::vector<std::string>>& rows, unsigned indent) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line(indent, ' ');
    for (std::size_t c = 0; c < row.size(); ++c) {
      line += row[c];
      if (c + 1 < row.size()) line += std::string(widths[c] - row[c].size() + 2, ' ');
    }
    while (line.ends_with(' ')) line.pop_back();
    text += line + "\n";
  }
  return text;
}

std::string milliseconds(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.1f ms", value);
  return text.data();
}

double inMilliseconds(Duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

std::string knownTo(Duration error) {
  if (error == Duration{0}) return "";
  const auto shown = std::chrono::ceil<std::chrono::microseconds>(error);
  return ", known to " + std::to_string(shown.count()) + " us";
}

void print(const std::string& text) {
  if (!loop::writeOut(text)) throw ReaderGone("nobody reads standard output");
}

void printJson(const Json& json) {
  print(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

void printLine(const Json& json) {
  print(json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace suture::cli
