# This says how a fuzzer is built and run: each source is compiled once with clang and the sanitizers; one program has
# all parts right, and in another a wrong part replaces one of them, which the fuzzer must find.

set(SUTURE_FUZZ_FLAGS -std=c++20 -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all)

# Compiles SOURCES; ${group}_objects lists the results, one for each source.
function(suture_fuzz_objects group)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;FLAGS")
  foreach(source IN LISTS arg_SOURCES)
    get_filename_component(source ${source} ABSOLUTE)
    cmake_path(IS_PREFIX PROJECT_BINARY_DIR ${source} written)
    if(NOT written AND NOT EXISTS ${source})  # the build of fuzzers alone would find it, which is rare
      message(FATAL_ERROR "A fuzzer needs ${source}, which is not there: say in tests/fuzz/CMakeLists.txt what it has become")
    endif()
    get_filename_component(name ${source} NAME)
    set(object ${CMAKE_CURRENT_BINARY_DIR}/${group}/${name}.o)
    list(APPEND objects ${object})
    add_custom_command(
      OUTPUT ${object}
      COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} ${SUTURE_CLANGXX} ${SUTURE_FUZZ_FLAGS} -fsanitize=fuzzer-no-link
        -I${PROJECT_SOURCE_DIR} ${arg_FLAGS} -MD -MF ${object}.d -MT ${object} -c ${source} -o ${object}
      DEPENDS ${source}
      DEPFILE ${object}.d
      COMMENT "clang 19: ${name} for fuzzing"
      VERBATIM)
  endforeach()
  set(${group}_objects ${objects} PARENT_SCOPE)
endfunction()

# A source that is compiled for fuzzing stands before the same in a library, which may be one object of many sources.
function(suture_fuzz_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "OBJECTS;LIBRARIES;FLAGS")
  set(ours ${arg_LIBRARIES})
  list(FILTER ours INCLUDE REGEX TARGET_FILE)
  add_custom_command(
    OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}
    COMMAND ${SUTURE_CLANGXX} ${SUTURE_FUZZ_FLAGS} ${arg_FLAGS} ${arg_OBJECTS}
      -Wl,--allow-multiple-definition -Wl,--start-group ${arg_LIBRARIES} -Wl,--end-group -o ${CMAKE_CURRENT_BINARY_DIR}/${name}
    DEPENDS ${arg_OBJECTS} ${ours}
    COMMENT "${name} with clang 19"
    VERBATIM)
endfunction()

# NAME_fuzz of the objects COMMON and RIGHT, its corpus of the files SEEDS, and its tests. NAME_planted has WRONG in the
# place of RIGHT.
function(suture_fuzzer name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "RUNS" "COMMON;RIGHT;WRONG;LIBRARIES;SEEDS")
  set(folder ${CMAKE_CURRENT_BINARY_DIR})
  suture_fuzz_program(${name}_fuzz OBJECTS ${arg_COMMON} ${arg_RIGHT} LIBRARIES ${arg_LIBRARIES} FLAGS -fsanitize=fuzzer)
  suture_fuzz_program(${name}_planted OBJECTS ${arg_COMMON} ${arg_WRONG} LIBRARIES ${arg_LIBRARIES} FLAGS -fsanitize=fuzzer)
  add_custom_target(${name}_fuzzer DEPENDS ${folder}/${name}_fuzz ${folder}/${name}_planted)
  add_dependencies(fuzzers ${name}_fuzzer)

  file(MAKE_DIRECTORY ${folder}/corpus/${name} ${folder}/found/${name} ${folder}/found/${name}_planted)
  foreach(seed IN LISTS arg_SEEDS)
    file(SHA1 ${seed} sum)
    file(COPY_FILE ${seed} ${folder}/corpus/${name}/${sum} ONLY_IF_DIFFERENT)
  endforeach()
  set(options -runs=${arg_RUNS} -seed=1 -max_len=8192 -timeout=10)
  add_test(NAME fuzz.${name} COMMAND ${name}_fuzz ${options} -print_final_stats=1
    -artifact_prefix=found/${name}_ found/${name} corpus/${name} WORKING_DIRECTORY ${folder})
  add_test(NAME fuzz.${name}.planted COMMAND ${name}_planted ${options}
    -artifact_prefix=found/${name}_planted_ found/${name}_planted corpus/${name} WORKING_DIRECTORY ${folder})
  set_tests_properties(fuzz.${name} fuzz.${name}.planted PROPERTIES LABELS long)
  set_tests_properties(fuzz.${name}.planted PROPERTIES PASS_REGULAR_EXPRESSION "libFuzzer: deadly signal")
endfunction()

# Makes the fuzzer of all decoders that the generated files ROOT/STEM.wire.cpp define; OBJECTS define what their
# headers only declare. TARGET has capnp write the headers of their schemas.
function(suture_decoders_fuzzer name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "ROOT;TARGET" "STEMS;FLAGS;OBJECTS;LIBRARIES")
  set(folder ${CMAKE_CURRENT_BINARY_DIR})
  set(list ${folder}/${name}_decoders.cpp)
  set(script ${CMAKE_CURRENT_SOURCE_DIR}/write_decoders.py)
  list(TRANSFORM arg_STEMS PREPEND ${arg_ROOT}/ OUTPUT_VARIABLE sources)
  list(TRANSFORM sources APPEND .wire.cpp)
  add_custom_command(OUTPUT ${list} COMMAND ${Python3_EXECUTABLE} ${script} ${list} ${arg_ROOT} ${arg_STEMS}
    DEPENDS ${script} ${sources} VERBATIM)
  suture_fuzz_objects(right SOURCES ${list} FLAGS ${decoder_flags} -I${arg_ROOT} ${arg_FLAGS})
  suture_fuzzer(${name} COMMON ${decoders_objects} ${messages_objects} ${arg_OBJECTS} RIGHT ${right_objects} WRONG ${decoders_wrong_objects}
    LIBRARIES ${arg_LIBRARIES} RUNS 20000)
  add_dependencies(${name}_fuzzer ${arg_TARGET})

  suture_fuzz_program(${name}_seeds OBJECTS ${right_objects} ${seeds_objects} ${messages_objects} ${arg_OBJECTS} LIBRARIES ${arg_LIBRARIES})
  add_custom_target(${name}_corpus DEPENDS ${folder}/${name}_seeds
    COMMAND ${folder}/${name}_seeds ${folder}/corpus/${name})
  add_dependencies(${name}_fuzzer ${name}_corpus)
endfunction()
