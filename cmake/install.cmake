# What `make install` and the Debian packages put where, below a prefix that is chosen then:
#   component interlock   bin/interlock; share/interlock: scripts and page of the report, cases; completion, manual
#   component dev         headers in include/interlock, libraries in lib, what find_package(Interlock) reads
#   component python      the module of Python (python/CMakeLists.txt)
# share/interlock has the layout of the checkout, and the build folder has links to the same places, so that the
# program finds everything by one rule (apps/shared_files.h).
include(CMakePackageConfigHelpers)

file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/interlock)
foreach(part apps cases CITATION.cff)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${part} ${PROJECT_BINARY_DIR}/share/interlock/${part} SYMBOLIC)
endforeach()

# --- The program -----------------------------------------------------------------------------------
if(INTERLOCK_VECTOR_LEVELS)
  set_target_properties(interlock PROPERTIES INSTALL_RPATH "$ORIGIN/../lib")
endif()
install(TARGETS interlock RUNTIME DESTINATION bin COMPONENT interlock)
file(GLOB scripts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/apps/*.py)
install(PROGRAMS ${scripts} DESTINATION share/interlock/apps COMPONENT interlock)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/apps/report DESTINATION share/interlock/apps COMPONENT interlock)
install(FILES ${PROJECT_SOURCE_DIR}/CITATION.cff DESTINATION share/interlock COMPONENT interlock)
# Scripts around the cases build on a checkout and stay there.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/cases DESTINATION share/interlock COMPONENT interlock
  FILES_MATCHING PATTERN "*.prm" PATTERN "*.msh" PATTERN "*.json" PATTERN "*.gz")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/interlock RENAME copyright COMPONENT interlock)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION share/doc/interlock
  COMPONENT interlock)

# Manual and completion say what the program says.
if(NOT INTERLOCK_SANITIZE)
  set(share ${PROJECT_BINARY_DIR}/share)
  set(manual ${share}/man/man1/interlock.1)
  set(completion ${share}/bash-completion/completions/interlock)
  set(script ${PROJECT_SOURCE_DIR}/scripts/manual_and_completion.py)
  add_custom_command(OUTPUT ${manual} ${completion} DEPENDS interlock ${script}
    COMMAND /usr/bin/python3 ${script} $<TARGET_FILE:interlock> ${share} ${PROJECT_VERSION})
  add_custom_target(manual_and_completion ALL DEPENDS ${manual} ${completion})
  install(FILES ${manual} DESTINATION share/man/man1 COMPONENT interlock)
  install(FILES ${completion} DESTINATION share/bash-completion/completions COMPONENT interlock)
endif()

# --- The libraries ---------------------------------------------------------------------------------
set_target_properties(interlock_options PROPERTIES EXPORT_NAME options)
install(TARGETS dem fem coupling interlock_options EXPORT InterlockTargets
  ARCHIVE DESTINATION lib COMPONENT dev
  LIBRARY DESTINATION lib COMPONENT interlock NAMELINK_COMPONENT dev)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/dem ${PROJECT_SOURCE_DIR}/fem ${PROJECT_SOURCE_DIR}/coupling
  DESTINATION include/interlock COMPONENT dev FILES_MATCHING PATTERN "*.h")
# Debug information names folders of the machine that compiled.
find_program(STRIP strip REQUIRED)
install(CODE "
  file(GLOB archives \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/lib/libinterlock_*.a\")
  foreach(archive IN LISTS archives)
    execute_process(COMMAND ${STRIP} --strip-debug \"\${archive}\")
  endforeach()" COMPONENT dev)

set(config_folder lib/cmake/Interlock)
install(EXPORT InterlockTargets NAMESPACE Interlock:: DESTINATION ${config_folder} COMPONENT dev)
configure_package_config_file(cmake/InterlockConfig.cmake.in ${PROJECT_BINARY_DIR}/InterlockConfig.cmake
  INSTALL_DESTINATION ${config_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/InterlockConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/InterlockConfig.cmake ${PROJECT_BINARY_DIR}/InterlockConfigVersion.cmake
  DESTINATION ${config_folder} COMPONENT dev)

include(cmake/debian_packages.cmake)
