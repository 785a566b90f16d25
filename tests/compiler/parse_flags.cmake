# suture_parse_flags is what the tests give suturec to parse with. The standard headers and Eigen are precompiled, since
# reading them is most of what a run of suturec does, and the tests here run it some hundred times.
find_program(SUTURE_CLANGXX clang++-19 REQUIRED)
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
set(precompiled ${PROJECT_BINARY_DIR}/tests/compiler/standard_headers.pch)
if(NOT TARGET suture_standard_headers)
  set(standard_headers ${CMAKE_CURRENT_LIST_DIR}/standard_headers.h)
  # This takes the options that suturec itself gives to Clang, without which it refuses the file. Clang would instantiate
  # the templates that the headers use in each run anew, which was half of a run, did it not when it precompiles them.
  add_custom_command(
    OUTPUT ${precompiled}
    COMMAND ${SUTURE_CLANGXX} -std=c++20 -DSUTUREC -nocudainc -nocudalib -fpch-instantiate-templates -isystem ${eigen} -MD -MT ${precompiled}
      -MF ${precompiled}.d -x c++-header ${standard_headers} -o ${precompiled}
    DEPENDS ${standard_headers}
    DEPFILE ${precompiled}.d
    COMMENT "Precompiling the standard headers for suturec's tests"
    VERBATIM)
  add_custom_target(suture_standard_headers ALL DEPENDS ${precompiled})
endif()
set(suture_parse_flags -include-pch ${precompiled} -isystem ${eigen})
