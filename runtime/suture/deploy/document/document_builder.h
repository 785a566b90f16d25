#pragma once
// This reads a JSON text into a JsonDocument, from the events of nlohmann's parser and a count of
// the characters that it has taken.

#include <suture/deploy/document/json_document.h>

#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// A DocumentBuilder is one parse. nlohmann::json::sax_parse calls the public members without a
/// comment.
class DocumentBuilder {
 public:
  DocumentBuilder(JsonDocument& document, std::string_view text)
      : document_(document), text_(text) {}

  /// Throws DocumentError.
  void build();

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(std::int64_t value) { return add(value); }
  bool number_unsigned(std::uint64_t value) { return add(value); }
  bool number_float(double value, const std::string&) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  bool binary(nlohmann::json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(nlohmann::json::object()); }
  bool key(std::string& name);
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(nlohmann::json::array()); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::json::exception& error);

  /// Says how far the parser has read.
  struct Taken {
    std::size_t characters = 0;
    int line = 1;  // the line of the last character
  };

 private:
  struct Frame {
    nlohmann::json* container;
    std::string pointer;
    std::string key;  // the next member has this key
  };

  /// Puts a value into the innermost container and returns it there.
  nlohmann::json& place(nlohmann::json value);
  bool add(nlohmann::json value);
  bool open(nlohmann::json container);
  bool close();
  int lineNow() const { return taken_.line; }
  std::string nextPointer() const;

  JsonDocument& document_;
  std::string_view text_;
  Taken taken_;
  std::vector<Frame> open_;
  std::vector<std::string> problems_;
};

}  // namespace suture
