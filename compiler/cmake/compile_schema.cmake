# cmake -DCAPNP=program -DPLUGIN=program -DSCHEMAS=dir -DSTEM=stem -DPARTS=list -DIMPORTS=list -DOUT=dir -P compile_schema.cmake
#
# Compiles SCHEMAS/PART.capnp to OUT/PART.capnp.{h,c++} for each part, which is STEM alone for a header that is not big. Else OUT/STEM.capnp.h
# includes what is written for all of them.

cmake_minimum_required(VERSION 3.25)

# capnp refuses a folder that is not there; for a compiler that is no error.
foreach(directory IN LISTS SCHEMAS IMPORTS)
  if(IS_DIRECTORY "${directory}")
    list(APPEND imports "-I${directory}")
  endif()
endforeach()
list(REMOVE_DUPLICATES imports)

# Write aside first, so that a run that fails or is killed leaves no half of a file in place.
set(new "${OUT}/new")
file(MAKE_DIRECTORY "${new}")
foreach(part IN LISTS PARTS)
  list(APPEND files ${SCHEMAS}/${part}.capnp)
endforeach()
execute_process(
  COMMAND ${CAPNP} compile -o${PLUGIN}:${new} --src-prefix ${SCHEMAS} ${imports} ${files}
  RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "capnp compile ${SCHEMAS}/${STEM}.capnp failed")
endif()
get_filename_component(folder "${OUT}/${STEM}" DIRECTORY)
file(MAKE_DIRECTORY "${folder}")
set(all "#pragma once\n")
foreach(part IN LISTS PARTS)
  foreach(ending c++ h)
    file(RENAME "${new}/${part}.capnp.${ending}" "${OUT}/${part}.capnp.${ending}")
  endforeach()
  get_filename_component(name ${part} NAME)
  string(APPEND all "#include \"${name}.capnp.h\"\n")
endforeach()
if(NOT PARTS STREQUAL STEM)
  file(WRITE "${new}/${STEM}.capnp.h" "${all}")
  file(RENAME "${new}/${STEM}.capnp.h" "${OUT}/${STEM}.capnp.h")
endif()
