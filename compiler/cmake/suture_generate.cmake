# suture_generate(TARGET t HEADERS h... [BASE_DIR d] [LOCK_DIR d] [LOCK_PATH d...] [DEPENDS t...] [INSTALL_DIR d]
#                 [LOADABLE] [RUNTIME t])
#
# Adds to target t the code that carries what its annotated headers declare. Users of t include
# "X.suture.h" for each header X.h.
#
#   TARGET     an existing library or executable of the calling directory
#   HEADERS    its annotated headers, all in one call
#   BASE_DIR   include root: "arm/arm.h" is a path below it. Default: the calling directory
#   LOCK_DIR   folder of the locked schemas, committed. Default: <project>/schemas
#   LOCK_PATH  lock folders of other projects in this build whose headers these include. The lock of an
#              installed header is found beside it
#   DEPENDS    targets that exist before this call, or files, that must be built before suturec can read these headers: a build step
#              writes a header that they include, directly or not
#   INSTALL_DIR  include root below the install prefix, say "include": install() then puts there what other
#              projects need of these headers, and whoever imports t finds it
#   LOADABLE   deployments may name t, a shared library, and create its components by class name: t gets the
#              entry point suture_components() of suture/component/factory/component_library.h
#   RUNTIME    target to link instead of the whole runtime, for contracts that the runtime itself links
#
# Set SUTUREC_EXECUTABLE before to the suturec to run, where that of the package is for another machine.
# A header that declares more than SUTURE_DECLARATIONS_PER_SOURCE types, commands and events (100 if it is not set) gives several sources,
# and capnp compiles its schema in as many parts.
# With suturec at hand it runs at build time: once per change of anything the headers read, and it
# rewrites only files whose text changes. Without it, what is committed in <project>/generated is compiled.
# suturec sees the macros and include paths of t: its definitions and include directories, and -D, -U, -I, -isystem, -iquote, -idirafter,
# -include and -imacros of its options, of CMAKE_CXX_FLAGS and of the configuration's flags. It does not see precompiled headers.
# The targets update-lock, accept-break and update-generated serve all calls; a project that has a folder generated/ when CMake runs gets
# the test check-generated.

include(${CMAKE_CURRENT_LIST_DIR}/suture_generate_checks.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/suture_generate_parts.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/suture_generate_upkeep.cmake)

function(suture_generate)
  cmake_parse_arguments(PARSE_ARGV 0 arg "LOADABLE" "TARGET;BASE_DIR;LOCK_DIR;INSTALL_DIR;RUNTIME" "HEADERS;LOCK_PATH;DEPENDS")
  suture_check_arguments("${arg_UNPARSED_ARGUMENTS}" "${arg_KEYWORDS_MISSING_VALUES}")
  suture_check_target("${arg_TARGET}")
  suture_default(arg_BASE_DIR ${CMAKE_CURRENT_SOURCE_DIR})
  suture_default(arg_LOCK_DIR ${PROJECT_SOURCE_DIR}/schemas)
  suture_check_lock_path("${arg_LOCK_PATH}")
  suture_check_install_dir("${arg_INSTALL_DIR}")
  suture_stems(stems ${arg_TARGET} "${arg_BASE_DIR}" "${arg_HEADERS}")

  set(entry "")
  if(arg_LOADABLE)
    suture_check_loadable(${arg_TARGET})
    set(entry ${arg_TARGET}.components.cpp)
  endif()
  foreach(stem IN LISTS stems)
    suture_count_sources(${stem} "${arg_BASE_DIR}")
  endforeach()
  set(wire ${CMAKE_BINARY_DIR}/generated-wire)
  set(lock_dirs ${arg_LOCK_DIR} ${arg_LOCK_PATH})
  suture_find_compiler(suturec)
  if(suturec)
    set(generated ${CMAKE_BINARY_DIR}/generated)
    set(schemas ${generated})
    suture_define_inputs(${arg_TARGET} "${arg_DEPENDS}")
    suture_run_compiler("${suturec}" ${arg_TARGET} "${arg_BASE_DIR}" "${generated}" "${lock_dirs}" "${stems}" "${entry}")
    suture_register_upkeep("${suturec}" ${arg_TARGET} "${stems}" "${entry}")
  else()
    set(generated ${PROJECT_SOURCE_DIR}/generated)
    set(schemas ${arg_LOCK_DIR})
    suture_check_committed(${arg_TARGET} "${generated}" "${stems}" "${entry}")
  endif()

  foreach(stem IN LISTS stems)
    suture_outputs(sources ${stem} compile)
    list(TRANSFORM sources PREPEND ${generated}/)
    target_sources(${arg_TARGET} PRIVATE ${sources})
    # Without suturec, a header that has no lock declares nothing for a wire.
    if(suturec OR EXISTS ${schemas}/${stem}.capnp)
      suture_outputs(parts ${stem} part)
      if(parts)
        suture_compile_schema(${arg_TARGET} "${generated}" ${stem} "${wire}" "${lock_dirs}")
      else()
        suture_compile_schema(${arg_TARGET} "${schemas}" ${stem} "${wire}" "${lock_dirs}")
      endif()
    endif()
    if(arg_INSTALL_DIR)
      suture_install(${stem} ${arg_INSTALL_DIR} "${arg_BASE_DIR}" "${generated}" "${arg_LOCK_DIR}" "${wire}")
    endif()
  endforeach()
  if(entry)
    target_sources(${arg_TARGET} PRIVATE ${generated}/${entry})
  endif()
  suture_notice_removed(${arg_TARGET} "${generated}" "${wire}" "${stems}")
  target_include_directories(${arg_TARGET} PUBLIC
    "$<BUILD_INTERFACE:${arg_BASE_DIR}>" "$<BUILD_INTERFACE:${generated}>")
  if(arg_INSTALL_DIR)
    target_include_directories(${arg_TARGET} INTERFACE $<INSTALL_INTERFACE:${arg_INSTALL_DIR}>)
  endif()
  # Only generated code includes Capnp's output, so that users of the target do not see it.
  target_include_directories(${arg_TARGET} SYSTEM PRIVATE "${wire}")
  if(NOT arg_RUNTIME)
    set(arg_RUNTIME suture::suture)
  endif()
  target_link_libraries(${arg_TARGET} PUBLIC ${arg_RUNTIME} PRIVATE CapnProto::capnp-rpc)
endfunction()
