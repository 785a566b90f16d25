# cmake -DCAPNP=program -DPLUGIN=program -DSCHEMAS=dir -DSTEM=stem -DIMPORTS=list -DOUT=dir -P compile_schema.cmake
#
# Compiles SCHEMAS/STEM.capnp to OUT/STEM.capnp.{h,c++}.

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
execute_process(
  COMMAND ${CAPNP} compile -o${PLUGIN}:${new} --src-prefix ${SCHEMAS} ${imports} ${SCHEMAS}/${STEM}.capnp
  RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "capnp compile ${SCHEMAS}/${STEM}.capnp failed")
endif()
get_filename_component(folder "${OUT}/${STEM}" DIRECTORY)
file(MAKE_DIRECTORY "${folder}")
foreach(ending c++ h)
  file(RENAME "${new}/${STEM}.capnp.${ending}" "${OUT}/${STEM}.capnp.${ending}")
endforeach()
