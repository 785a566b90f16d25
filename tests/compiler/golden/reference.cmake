# Runs SUTUREC on the headers of TESTS/reference and compares with the files beside them, which the tests of the
# runtime compile also where there is no suturec; with UPDATE copies what differs. EIGEN, RUNTIME: include folders;
# OUT: scratch.
file(REMOVE_RECURSE ${OUT})
execute_process(
  COMMAND ${SUTUREC} --target-name reference --base-dir . --out ${OUT} --lock-dir .
          reference/arm_types.h reference/arm_like.h reference/gripper_arm.h reference/simulated_arm.h -- -I. -I${RUNTIME} -isystem ${EIGEN}
  WORKING_DIRECTORY ${TESTS}
  RESULT_VARIABLE status)
if(status)
  message(FATAL_ERROR "suturec refuses the headers")
endif()

file(GLOB names RELATIVE ${OUT}/reference ${OUT}/reference/*.suture.h ${OUT}/reference/*.suture.cpp
     ${OUT}/reference/*.wire.cpp)
foreach(name IN LISTS names)
  if(UPDATE)
    configure_file(${OUT}/reference/${name} ${TESTS}/reference/${name} COPYONLY)
  else()
    execute_process(COMMAND diff -u ${TESTS}/reference/${name} ${OUT}/reference/${name} RESULT_VARIABLE differs)
    if(differs)
      message(SEND_ERROR "${name} is not what suturec writes; build the target update-reference and commit the result")
    endif()
  endif()
endforeach()
