# These targets keep what is committed in step with the headers: update-lock, accept-break (the same, where old peers no longer count) and
# update-generated, of all suture_generate() calls of a build, and the test check-generated of each project. Each call has targets of its
# own, which the common ones run: its suturec may be known in its directory alone.

function(suture_register_upkeep suturec target stems entry)
  suture_add_lock_target(update-lock "--update-lock" "${suturec}" ${target})
  suture_add_lock_target(accept-break "--update-lock;--accept-break" "${suturec}" ${target})

  suture_outputs(files "${stems}" include compile read part)
  set_property(GLOBAL APPEND PROPERTY SUTURE_UPKEEP_FILES_${PROJECT_SOURCE_DIR} ${entry} ${files})
  set_property(GLOBAL APPEND PROPERTY SUTURE_UPKEEP_TARGETS_${PROJECT_SOURCE_DIR} ${target}_suture)
  get_property(projects GLOBAL PROPERTY SUTURE_UPKEEP_PROJECTS)
  if(NOT PROJECT_SOURCE_DIR IN_LIST projects)
    set_property(GLOBAL APPEND PROPERTY SUTURE_UPKEEP_PROJECTS ${PROJECT_SOURCE_DIR})
    cmake_language(DEFER DIRECTORY ${PROJECT_SOURCE_DIR} CALL suture_compare_project)
  endif()
endfunction()

# Adds what the call for a target has to do for a common target, behind what earlier calls do: one target's lock imports another's.
function(suture_add_lock_target common arguments suturec target)
  set(work ${CMAKE_CURRENT_BINARY_DIR}/${target}.suture)
  suture_arguments_script(script ${work} CXX)
  add_custom_target(${target}_${common}
    COMMAND ${CMAKE_COMMAND} -P ${script}
    COMMAND ${suturec} @${work}.rsp ${arguments}
    WORKING_DIRECTORY ${CMAKE_BINARY_DIR}
    COMMENT "Updating the locked schemas of ${target}"
    VERBATIM)
  add_dependencies(${target}_${common} ${target}_inputs)
  if(NOT TARGET ${common})
    add_custom_target(${common})
  endif()
  get_property(earlier GLOBAL PROPERTY SUTURE_LAST_${common})
  if(earlier)
    add_dependencies(${target}_${common} ${earlier})
  endif()
  set_property(GLOBAL PROPERTY SUTURE_LAST_${common} ${target}_${common})
  add_dependencies(${common} ${target}_${common})
endfunction()

# Runs when all calls of a project are known.
function(suture_compare_project)
  get_property(projects GLOBAL PROPERTY SUTURE_UPKEEP_PROJECTS)
  list(FIND projects ${PROJECT_SOURCE_DIR} number)
  get_property(targets GLOBAL PROPERTY SUTURE_UPKEEP_TARGETS_${PROJECT_SOURCE_DIR})
  get_property(files GLOBAL PROPERTY SUTURE_UPKEEP_FILES_${PROJECT_SOURCE_DIR})
  set(list ${PROJECT_BINARY_DIR}/generated.list)
  list(JOIN files "\n" text)
  file(GENERATE OUTPUT ${list} CONTENT "${text}\n")
  set(committed ${PROJECT_SOURCE_DIR}/generated)
  set(script ${CMAKE_COMMAND} -DBUILT=${CMAKE_BINARY_DIR}/generated -DCOMMITTED=${committed} -DLIST=${list})
  set(path ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/sync_generated.cmake)
  add_custom_target(update-generated-${number} COMMAND ${script} -DUPDATE=ON -P ${path}
    VERBATIM COMMENT "Updating ${committed}")
  add_dependencies(update-generated-${number} ${targets})
  if(NOT TARGET update-generated)
    add_custom_target(update-generated)
  endif()
  add_dependencies(update-generated update-generated-${number})
  if(IS_DIRECTORY ${committed})
    add_test(NAME check-generated COMMAND ${script} -P ${path})
  endif()
endfunction()
