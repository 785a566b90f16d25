include(CMakeFindDependencyMacro)
find_dependency(Suture)
include(${CMAKE_CURRENT_LIST_DIR}/ContractTargets.cmake)
