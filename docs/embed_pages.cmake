# suture_embed_pages(TARGET folder header function): compiles the pages of a folder into a target. `header` declares
#   const std::map<std::string_view, std::string_view>& FUNCTION();
# which returns the text of each page by its name without .md. FUNCTION is qualified.

set(SUTURE_EMBED_PAGES ${CMAKE_CURRENT_LIST_FILE})

function(suture_embed_pages target folder header function)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${target}_pages.cpp)
  file(GLOB pages CONFIGURE_DEPENDS ${folder}/*.md)
  add_custom_command(
    OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} -DPAGES=${folder} -DOUT=${out} -DHEADER=${header} -DFUNCTION=${function} -P ${SUTURE_EMBED_PAGES}
    DEPENDS ${SUTURE_EMBED_PAGES} ${pages}
    COMMENT "Pages of ${folder} for ${target}"
    VERBATIM)
  target_sources(${target} PRIVATE ${out})
endfunction()

if(NOT CMAKE_SCRIPT_MODE_FILE)
  return()
endif()

file(GLOB pages ${PAGES}/*.md)
list(FILTER pages EXCLUDE REGEX README)
set(text "#include \"${HEADER}\"\n\nconst std::map<std::string_view, std::string_view>& ${FUNCTION}() {\n"
  "  static const std::map<std::string_view, std::string_view> pages{\n")
foreach(page IN LISTS pages)
  get_filename_component(name ${page} NAME_WE)
  file(READ ${page} content)
  # What stands behind the language of a block is for the tests of pages.
  string(REGEX REPLACE "(\n```[a-z]+) [^\n]*" "\\1" content "${content}")
  string(APPEND text "      {\"${name}\", R\"page(${content})page\"},\n")
endforeach()
string(APPEND text "  };\n  return pages;\n}\n")
file(WRITE ${OUT} "${text}")
