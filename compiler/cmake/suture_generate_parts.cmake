# These are the build steps behind suture_generate().

# Lists what suturec writes for the headers STEMS and a build uses so: include, compile, read, schema or part. The list is that of suturec
# --list-outputs, kept beside this file because suturec may not be built yet, or not be there.
function(suture_outputs result stems)
  set(list ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/outputs.list)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  file(STRINGS ${list} lines)
  set(files "")
  foreach(stem IN LISTS stems)
    get_property(sources GLOBAL PROPERTY SUTURE_SOURCES_${stem})
    foreach(line IN LISTS lines)
      string(REGEX MATCH "^([a-z]+) (.*)$" found "${line}")
      set(use ${CMAKE_MATCH_1})
      set(ending ${CMAKE_MATCH_2})
      if(NOT use IN_LIST ARGN OR (use STREQUAL part AND NOT sources GREATER 1))
        continue()
      endif()
      list(APPEND files ${stem}.${ending})
      if(use MATCHES "^(compile|part)$" AND sources GREATER 1)
        foreach(number RANGE 2 ${sources})
          string(REGEX REPLACE "([a-z]+)$" "${number}.\\1" numbered ${ending})
          list(APPEND files ${stem}.${numbered})
        endforeach()
      endif()
    endforeach()
  endforeach()
  set(${result} "${files}" PARENT_SCOPE)
endfunction()

# Says how many sources of each kind the header STEM gives: one for some 100 types and commands, so that no compiler needs gigabytes. It
# is counted when CMake runs; sources of a header that grows meanwhile are only bigger.
function(suture_count_sources stem base)
  if(NOT SUTURE_DECLARATIONS_PER_SOURCE)
    set(SUTURE_DECLARATIONS_PER_SOURCE 100)
  endif()
  set(sources 1)
  if(EXISTS ${base}/${stem}.h)
    file(STRINGS ${base}/${stem}.h annotated REGEX "SUTURE_(TYPE|EXTERNAL_TYPE|COMMAND|EVENT)\\(")
    list(LENGTH annotated count)
    math(EXPR sources "1 + ${count} / ${SUTURE_DECLARATIONS_PER_SOURCE}")
  endif()
  set_property(GLOBAL PROPERTY SUTURE_SOURCES_${stem} ${sources})
endfunction()

# Finds the directory of g++'s libraries, from which clang finds the same standard library.
function(suture_gcc_install_dir result)
  if(NOT DEFINED CACHE{SUTURE_GCC_INSTALL_DIR})
    set(directory "")
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-libgcc-file-name
        OUTPUT_VARIABLE libgcc OUTPUT_STRIP_TRAILING_WHITESPACE)
      get_filename_component(directory "${libgcc}" DIRECTORY)
    endif()
    set(SUTURE_GCC_INSTALL_DIR "${directory}" CACHE INTERNAL "")
  endif()
  set(${result} "${SUTURE_GCC_INSTALL_DIR}" PARENT_SCOPE)
endfunction()

# Returns what clang must know of the machine that is built for; nothing where it is this one.
function(suture_target_machine result)
  set(arguments "")
  if(CMAKE_CROSSCOMPILING)
    set(triple "${CMAKE_CXX_COMPILER_TARGET}")
    if(NOT triple)
      execute_process(COMMAND ${CMAKE_CXX_COMPILER} -dumpmachine
        OUTPUT_VARIABLE triple OUTPUT_STRIP_TRAILING_WHITESPACE)
    endif()
    set(arguments --target=${triple})
  endif()
  if(CMAKE_SYSROOT)
    list(APPEND arguments --sysroot=${CMAKE_SYSROOT})
  endif()
  set(${result} "${arguments}" PARENT_SCOPE)
endfunction()

# Says what writes WORK.rsp, with the arguments of suturec, when it is run by cmake -P. It is one file for each configuration, whose
# macros are its own.
function(suture_arguments_script result work language)
  set(config "")
  if(CMAKE_CONFIGURATION_TYPES)
    set(config ".$<CONFIG>")
  endif()
  set(${result} ${work}.${language}${config}.cmake PARENT_SCOPE)
endfunction()

# Writes that script; lists of the target are complete only when the build files are written. CMake evaluates them for each language
# of the project, and demands a file for each.
function(suture_write_arguments work target base generated lock_dirs stems entry)
  set(own --target-name ${target} --project ${PROJECT_NAME} --base-dir ${base} --out ${generated})
  list(APPEND own --lock-command "cmake --build ${CMAKE_BINARY_DIR} --target update-lock"
    --break-command "cmake --build ${CMAKE_BINARY_DIR} --target accept-break")
  foreach(directory IN LISTS lock_dirs)
    list(APPEND own --lock-dir ${directory})
  endforeach()
  if(entry)
    list(APPEND own --components-file ${entry})
  endif()
  foreach(stem IN LISTS stems)
    list(APPEND own ${base}/${stem}.h)
    get_property(sources GLOBAL PROPERTY SUTURE_SOURCES_${stem})
    if(sources GREATER 1)
      list(APPEND own --sources ${stem}.h=${sources})
    endif()
  endforeach()
  set(includes $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
  set(definitions $<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>)
  # Suture's headers are C++20, to which CMake raises the compiler of a target that asks for less.
  set(standard $<TARGET_PROPERTY:${target},CXX_STANDARD>)
  suture_gcc_install_dir(gcc)
  list(APPEND own -- "-std=c++$<IF:$<OR:$<STREQUAL:${standard},23>,$<STREQUAL:${standard},26>>,${standard},20>")
  if(gcc)
    list(APPEND own --gcc-install-dir=${gcc})
  endif()
  suture_target_machine(machine)
  list(APPEND own ${machine})
  list(JOIN own "\n" text)
  string(APPEND text "\n$<$<BOOL:${includes}>:-I$<JOIN:${includes},\n-I>>\n"
    "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},\n-D>>\n")
  set(script "set(arguments [==[\n${text}]==])\n")
  foreach(config IN LISTS CMAKE_CONFIGURATION_TYPES CMAKE_BUILD_TYPE)
    string(TOUPPER "${config}" config)
    string(APPEND script "set(flags_of_${config} [==[${CMAKE_CXX_FLAGS_${config}}]==])\n")
  endforeach()
  string(APPEND script
    "set(config \"$<UPPER_CASE:$<CONFIG>>\")\n"
    "set(flags [==[${CMAKE_CXX_FLAGS}]==])\n"
    "set(flags_of_target [==[$<TARGET_PROPERTY:${target},COMPILE_FLAGS>]==])\n"
    "set(options [==[$<TARGET_PROPERTY:${target},COMPILE_OPTIONS>]==])\n"
    "set(rsp [==[${work}.rsp]==])\n"
    "include([==[${CMAKE_CURRENT_FUNCTION_LIST_DIR}/write_response_file.cmake]==])\n")
  suture_arguments_script(file ${work} $<COMPILE_LANGUAGE>)
  file(GENERATE OUTPUT ${file} CONTENT "${script}" TARGET ${target})
endfunction()

# Defines TARGET_inputs, for which each run of suturec waits: it builds what DEPENDS names.
function(suture_define_inputs target depends)
  set(targets "")
  foreach(name IN LISTS depends)
    if(TARGET ${name})
      list(APPEND targets ${name})
      list(REMOVE_ITEM depends ${name})
    endif()
  endforeach()
  add_custom_target(${target}_inputs DEPENDS ${depends})
  if(targets)
    add_dependencies(${target}_inputs ${targets})
  endif()
endfunction()

# Runs suturec: the stamp says when it ran, and the generated files change only with their text. Of a command that fails Ninja prints all
# outputs and the command itself, before what the command says. So that a message is not buried, this one has one output and paths below
# the build folder; CMake would add a longer command that rewrites the depfile, which needs no rewriting.
function(suture_run_compiler suturec target base generated lock_dirs stems entry)
  set(work ${CMAKE_CURRENT_BINARY_DIR}/${target}.suture)
  file(RELATIVE_PATH below ${CMAKE_BINARY_DIR} ${work})
  suture_write_arguments(${work} ${target} ${base} ${generated} "${lock_dirs}" "${stems}" "${entry}")
  # The depfile names the stamp: Ninja knows it by its path below the build folder, and Make would look for that in this directory's.
  set(stamp ${below}.stamp)
  if(CMAKE_GENERATOR MATCHES "Makefiles")
    set(stamp ${work}.stamp)
  endif()
  suture_arguments_script(arguments ${work} CXX)
  suture_arguments_script(arguments_below ${below} CXX)
  foreach(stem IN LISTS stems)
    list(APPEND headers ${base}/${stem}.h)
  endforeach()
  cmake_policy(PUSH)
  cmake_policy(SET CMP0116 OLD)
  add_custom_command(
    OUTPUT ${work}.stamp
    COMMAND ${CMAKE_COMMAND} -P ${arguments_below}
    COMMAND ${suturec} @${below}.rsp --stamp ${stamp} --depfile ${below}.d
    DEPENDS ${suturec} ${arguments} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/write_response_file.cmake ${headers}
    DEPFILE ${work}.d
    WORKING_DIRECTORY ${CMAKE_BINARY_DIR}
    COMMENT "suturec ${target}"
    VERBATIM)
  cmake_policy(POP)

  suture_outputs(outputs "${stems}" include compile read schema part)
  list(APPEND outputs ${entry})
  list(TRANSFORM outputs PREPEND ${generated}/)
  set(script ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/write_missing.cmake)
  set(program ${suturec})
  if(TARGET ${suturec})
    set(program $<TARGET_FILE:${suturec}>)
  endif()
  add_custom_command(
    OUTPUT ${work}.written
    BYPRODUCTS ${outputs}
    COMMAND ${CMAKE_COMMAND} -DSUTUREC=${program} -DRSP=${work}.rsp -DWRITTEN=${work}.written "-DOUTPUTS=${outputs}" -P ${script}
    DEPENDS ${work}.stamp ${script}
    COMMENT "Files of ${target}"
    VERBATIM)
  set_source_files_properties(${outputs} PROPERTIES GENERATED TRUE)
  add_custom_target(${target}_suture DEPENDS ${work}.written)
  add_dependencies(${target}_suture ${target}_inputs)
  add_dependencies(${target} ${target}_suture)
  target_sources(${target} PRIVATE ${work}.written)
endfunction()

# Lists the schemas that capnp compiles for the header STEM, without their ending: its lock, or all parts of that.
function(suture_schema_stems result stem)
  suture_outputs(parts ${stem} part)
  if(NOT parts)
    set(parts ${stem}.capnp)
  endif()
  list(TRANSFORM parts REPLACE "\\.capnp$" "")
  set(${result} "${parts}" PARENT_SCOPE)
endfunction()

# Compiles the schema of a header. What capnp writes for the parts of a big one lies beside a STEM.capnp.h that includes all of them, which
# is the first output here because Make looks at that one only.
function(suture_compile_schema target schemas stem wire lock_dirs)
  # This does not use capnp_generate_cpp(), which cannot write several folders into one include root. Where a header of another package is
  # found, its schema is found too.
  set(imports ${lock_dirs} $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
  set(script ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/compile_schema.cmake)
  suture_schema_stems(parts ${stem})
  list(TRANSFORM parts APPEND .capnp.c++ OUTPUT_VARIABLE sources)
  list(TRANSFORM sources PREPEND ${wire}/)
  list(TRANSFORM parts APPEND .capnp.h OUTPUT_VARIABLE headers)
  list(TRANSFORM headers PREPEND ${wire}/)
  set(outputs ${sources} ${headers})
  if(NOT parts STREQUAL stem)
    list(PREPEND outputs ${wire}/${stem}.capnp.h)
  endif()
  list(TRANSFORM parts APPEND .capnp OUTPUT_VARIABLE inputs)
  list(TRANSFORM inputs PREPEND ${schemas}/)
  add_custom_command(
    OUTPUT ${outputs}
    COMMAND ${CMAKE_COMMAND} -DCAPNP=${CAPNP_EXECUTABLE} -DPLUGIN=${CAPNPC_CXX_EXECUTABLE}
      -DSCHEMAS=${schemas} -DSTEM=${stem} "-DPARTS=${parts}" "-DIMPORTS=${imports}" -DOUT=${wire} -P ${script}
    DEPENDS ${inputs} ${script}
    COMMENT "capnp ${stem}.capnp"
    VERBATIM)
  # An editor takes the command of this file for that of the header of its name, so it has the standard of the target.
  set_source_files_properties(${sources} PROPERTIES COMPILE_OPTIONS "-w;-include;suture/loop/kj_comparisons.h")
  target_sources(${target} PRIVATE ${outputs})
endfunction()

# Makes a build with Make notice an output that is gone; Ninja sees that by itself.
function(suture_notice_removed target generated wire stems)
  if(NOT CMAKE_GENERATOR MATCHES "Makefiles")
    return()
  endif()
  set(stamp "")
  if(TARGET ${target}_suture)
    set(stamp ${CMAKE_CURRENT_BINARY_DIR}/${target}.suture.stamp)
  endif()
  suture_outputs(outputs "${stems}" include compile read schema part)
  suture_outputs(parts "${stems}" part)
  add_custom_target(${target}_outputs
    COMMAND ${CMAKE_COMMAND} -DSTAMP=${stamp} -DGENERATED=${generated} -DWIRE=${wire} "-DSTEMS=${stems}" "-DPARTS=${parts}"
      "-DOUTPUTS=${outputs}"
      -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/notice_removed.cmake
    VERBATIM)
  add_dependencies(${target} ${target}_outputs)
  if(stamp)
    add_dependencies(${target}_suture ${target}_outputs)
  endif()
endfunction()

# Installs what generated code of other projects includes and imports beside the header.
function(suture_install stem root base generated lock_dir wire)
  get_filename_component(folder ${root}/${stem} DIRECTORY)
  suture_outputs(included "${stem}" include)
  list(TRANSFORM included PREPEND ${generated}/)
  install(FILES ${base}/${stem}.h ${included} DESTINATION ${folder})
  # A header that declares nothing for a wire has neither file, hence OPTIONAL.
  suture_outputs(parts ${stem} part)
  list(TRANSFORM parts PREPEND ${wire}/)
  list(TRANSFORM parts APPEND .h)
  install(FILES ${lock_dir}/${stem}.capnp ${wire}/${stem}.capnp.h ${parts} DESTINATION ${folder} OPTIONAL)
endfunction()
