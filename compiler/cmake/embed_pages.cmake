# cmake -DPAGES=dir -DOUT=file -P embed_pages.cmake: the pages of docs/diagnostics as C++.

file(GLOB pages ${PAGES}/*.md)
list(FILTER pages EXCLUDE REGEX README)
set(text "#include \"compiler/driver/explain.h\"\n\nnamespace suture::compiler::driver {\n\n"
  "const std::map<std::string_view, std::string_view>& diagnosticPages() {\n"
  "  static const std::map<std::string_view, std::string_view> pages{\n")
foreach(page IN LISTS pages)
  get_filename_component(slug ${page} NAME_WE)
  file(READ ${page} content)
  string(APPEND text "      {\"${slug}\", R\"page(${content})page\"},\n")
endforeach()
string(APPEND text "  };\n  return pages;\n}\n\n}  // namespace suture::compiler::driver\n")
file(WRITE ${OUT} "${text}")
