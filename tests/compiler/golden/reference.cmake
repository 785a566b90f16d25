# Runs SUTUREC on the headers of TESTS/reference and compares with the files beside them, the model of
# generated code, which has a shorter description and no hash. EIGEN, RUNTIME: include folders; OUT: scratch.
file(REMOVE_RECURSE ${OUT})
execute_process(
  COMMAND ${SUTUREC} --target-name reference --base-dir . --out ${OUT} --lock-dir .
          reference/arm_types.h reference/arm_like.h reference/gripper_arm.h reference/simulated_arm.h -- -I. -I${RUNTIME} -isystem ${EIGEN}
  WORKING_DIRECTORY ${TESTS}
  RESULT_VARIABLE status)
if(status)
  message(FATAL_ERROR "suturec refuses the headers")
endif()

function(read_normalised path result)
  file(READ ${path} text)
  string(FIND "${text}" "R\"json(" begin)
  while(NOT begin EQUAL -1)
    string(SUBSTRING "${text}" 0 ${begin} before)
    string(SUBSTRING "${text}" ${begin} -1 rest)
    string(FIND "${rest}" ")json\"" end)
    string(SUBSTRING "${rest}" ${end} -1 after)
    string(APPEND before "R\"description")
    set(text "${before}${after}")
    string(FIND "${text}" "R\"json(" begin)
  endwhile()
  string(REGEX REPLACE "\\.hash = \"[a-z0-9]+\"" "" text "${text}")
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

foreach(name arm_types.suture.h arm_types.suture.cpp arm_like.suture.h arm_like.suture.cpp gripper_arm.suture.h
    gripper_arm.suture.cpp simulated_arm.suture.h simulated_arm.suture.cpp)
  read_normalised(${TESTS}/reference/${name} model)
  read_normalised(${OUT}/reference/${name} generated)
  if(NOT model STREQUAL generated)
    execute_process(COMMAND diff -u ${TESTS}/reference/${name} ${OUT}/reference/${name})
    message(SEND_ERROR "${name} is not what its model says")
  endif()
endforeach()
