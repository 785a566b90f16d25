# suture_test_warnings(NAME COMPILERS ROOT FLAG...) runs these compilers on all that is generated below ROOT. Only
# clang has to compile what the build itself compiles as strictly.
find_program(SUTURE_CLANGXX clang++-19)
find_package(Python3 REQUIRED COMPONENTS Interpreter)
get_target_property(suture_test_eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
set(suture_test_warnings_script ${CMAKE_CURRENT_LIST_DIR}/warnings_test.py)

function(suture_test_warnings name compilers root)
  list(REMOVE_DUPLICATES compilers)  # the sanitizers' presets build with clang
  foreach(compiler IN LISTS compilers)
    get_filename_component(short ${compiler} NAME)
    add_test(NAME golden.warnings.${name}.${short}
      COMMAND ${Python3_EXECUTABLE} ${suture_test_warnings_script} ${compiler} ${root} ${ARGN}
        -I${PROJECT_SOURCE_DIR}/runtime -isystem ${PROJECT_BINARY_DIR}/schemas -isystem ${suture_test_eigen})
    # The fast tier leaves these out: they need what every target of the tree generates.
    set_tests_properties(golden.warnings.${name}.${short} PROPERTIES LABELS warnings)
    suture_compiling_tests(golden.warnings.${name}.${short})
  endforeach()
endfunction()
