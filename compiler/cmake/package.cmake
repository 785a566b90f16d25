# This defines what find_package(Suture) finds: after `cmake --install`, in a folder that may be moved anywhere, and in the build folder for
# work on Suture itself. The install components are suture, and robots on top of it.

include(CMakePackageConfigHelpers)

set(libraries)
foreach(name base rt component wiring testing loop net framing codec lane names session standard manager observe record deploy suture schemas)
  set_target_properties(suture_${name} PROPERTIES EXPORT_NAME ${name})
  list(APPEND libraries suture_${name})
endforeach()
set(robots robots robots_contracts robots_core robots_kinematics robots_vision robots_vision_core)
set_target_properties(${libraries} ${robots} PROPERTIES
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(programs suture-manager suture_cli)
if(TARGET suturec)
  set_target_properties(suturec PROPERTIES INSTALL_RPATH_USE_LINK_PATH ON)  # LLVM may be anywhere
  list(APPEND programs suturec)
endif()

# Writes the same two files into a folder, beside its SutureTargets.cmake.
function(suture_write_config folder modules)
  set(SUTURE_MODULES "${modules}")
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/SutureConfig.cmake.in ${folder}/SutureConfig.cmake @ONLY)
  write_basic_package_version_file(${folder}/SutureConfigVersion.cmake COMPATIBILITY SameMinorVersion)
endfunction()
set(installed ${PROJECT_BINARY_DIR}/installed)
suture_write_config(${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_LIST_DIR})
suture_write_config(${installed} "\${CMAKE_CURRENT_LIST_DIR}")

export(TARGETS ${libraries} ${programs} NAMESPACE suture:: FILE ${PROJECT_BINARY_DIR}/SutureTargets.cmake)
export(TARGETS ${robots} NAMESPACE suture:: FILE ${PROJECT_BINARY_DIR}/SutureRobotsTargets.cmake)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Suture)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME suture)
install(TARGETS ${libraries} ${programs} EXPORT SutureTargets)
install(EXPORT SutureTargets NAMESPACE suture:: DESTINATION ${package})
install(FILES
  ${installed}/SutureConfig.cmake
  ${installed}/SutureConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/suture_generate.cmake
  ${CMAKE_CURRENT_LIST_DIR}/suture_generate_checks.cmake
  ${CMAKE_CURRENT_LIST_DIR}/suture_generate_parts.cmake
  ${CMAKE_CURRENT_LIST_DIR}/suture_generate_upkeep.cmake
  ${CMAKE_CURRENT_LIST_DIR}/compile_schema.cmake
  ${CMAKE_CURRENT_LIST_DIR}/notice_removed.cmake
  ${CMAKE_CURRENT_LIST_DIR}/write_missing.cmake
  ${CMAKE_CURRENT_LIST_DIR}/write_response_file.cmake
  ${CMAKE_CURRENT_LIST_DIR}/outputs.list
  ${CMAKE_CURRENT_LIST_DIR}/sync_generated.cmake
  DESTINATION ${package})
# Schemas lie beside headers, as Cap'n Proto's own do, so that the path to the one also finds the other.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/runtime/suture/ ${PROJECT_SOURCE_DIR}/schemas/suture/
  ${PROJECT_BINARY_DIR}/schemas/suture/
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/suture FILES_MATCHING PATTERN "*.h" PATTERN "*.capnp"
  PATTERN standard EXCLUDE)  # runtime/suture/standard/ and suture_generate() install those
install(FILES ${PROJECT_SOURCE_DIR}/schemas/deployment.schema.json ${PROJECT_SOURCE_DIR}/schemas/policy.schema.json
  DESTINATION share/suture)
# The documents lie as in the source tree, since they link each other and the examples.
install(FILES SECURITY.md CHANGELOG.md LICENSE DESTINATION share/doc/suture)
install(DIRECTORY docs examples DESTINATION share/doc/suture PATTERN site EXCLUDE PATTERN __pycache__ EXCLUDE
  PATTERN *.sh PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
# The README leads to these, so they are there without what they are about.
foreach(page README.md CONTRIBUTING.md compiler/README.md compiler/cmake/README.md components/README.md runtime/README.md
    runtime/cli/README.md runtime/gdb/README.md runtime/suture/README.md runtime/suture/standard/README.md tests/bench/README.md)
  get_filename_component(folder ${page} DIRECTORY)
  install(FILES ${page} DESTINATION share/doc/suture/${folder})
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/runtime/gdb/suture_printers.py DESTINATION share/suture/gdb)
if(TARGET suturec)
  # This is where suturec looks first: clang's own headers stay with it.
  install(DIRECTORY ${SUTURE_CLANG_RESOURCE_DIR}/include DESTINATION lib/suture/clang)
endif()

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME robots)
install(TARGETS ${robots} EXPORT SutureRobotsTargets)
install(TARGETS suture-workstation suture-demo)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/teleoperation/
  DESTINATION share/suture/teleoperation FILES_MATCHING PATTERN "*.json")
install(EXPORT SutureRobotsTargets NAMESPACE suture:: DESTINATION ${package})
# These are the headers that are not annotated; suture_generate() installs the others.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/components/
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/suture-robots FILES_MATCHING PATTERN "*.h")
