# Runs SUTUREC on the headers of ROOT and compares what it writes with ROOT/expected. EIGEN, RUNTIME: include
# folders; OUT: scratch.
file(REMOVE_RECURSE ${OUT})

function(run)
  execute_process(
    COMMAND ${SUTUREC} --target-name robots --base-dir . --out ${OUT} --lock-dir expected ${ARGN}
            -- -I. -I${RUNTIME} -isystem ${EIGEN}
    WORKING_DIRECTORY ${ROOT}
    RESULT_VARIABLE status)
  if(status)
    message(FATAL_ERROR "suturec refuses the headers")
  endif()
endfunction()

run(robots/geometry.h)
run(robots/arm.h robots/gripper.h robots/simulated_arm.h)
foreach(stem robots/geometry robots/arm robots/gripper robots/simulated_arm)
  file(GLOB names RELATIVE ${OUT} ${OUT}/${stem}.suture.* ${OUT}/${stem}.wire.cpp)
  foreach(name IN LISTS names)
    execute_process(COMMAND diff -u ${ROOT}/expected/${name} ${OUT}/${name} RESULT_VARIABLE differs)
    if(differs)
      message(SEND_ERROR "${name} is not what is expected")
    endif()
  endforeach()
endforeach()
