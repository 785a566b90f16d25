#pragma once
// Finds declarations by their qualified C++ name across all headers of a model.

#include <string>
#include <unordered_map>

#include "compiler/model/model.h"

namespace suture::compiler::model {

/// Finds declarations in the model, which must outlive it and stay unchanged.
class Lookup {
 public:
  explicit Lookup(const Model& model);

  /// Returns null when the model has no such declaration.
  const Struct* findStruct(const std::string& name) const { return find(structs_, name); }
  const Enum* findEnum(const std::string& name) const { return find(enums_, name); }
  const Interface* findInterface(const std::string& name) const { return find(interfaces_, name); }
  /// Returns the header that declares it.
  const Header* headerOf(const std::string& name) const { return find(headers_, name); }

 private:
  template <class T>
  using Table = std::unordered_map<std::string, const T*>;

  template <class T>
  static const T* find(const Table<T>& table, const std::string& name) {
    const auto found = table.find(name);
    return found == table.end() ? nullptr : found->second;
  }

  Table<Struct> structs_;
  Table<Enum> enums_;
  Table<Interface> interfaces_;
  Table<Header> headers_;
};

}  // namespace suture::compiler::model
