#include "compiler/model/lookup.h"

namespace suture::compiler::model {
namespace {

template <class T>
void enter(const std::vector<T>& declarations, const Header& header,
           std::unordered_map<std::string, const T*>& table,
           std::unordered_map<std::string, const Header*>& headers) {
  for (const T& declaration : declarations) {
    table.emplace(declaration.name, &declaration);
    headers.emplace(declaration.name, &header);
  }
}

}  // namespace

Lookup::Lookup(const Model& model) {
  for (const Header& header : model.headers) {
    enter(header.enums, header, enums_, headers_);
    enter(header.structs, header, structs_, headers_);
    enter(header.interfaces, header, interfaces_, headers_);
  }
}

}  // namespace suture::compiler::model
