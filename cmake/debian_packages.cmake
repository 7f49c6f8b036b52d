# `make deb`: Debian packages of the components of install.cmake, made by CPack.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME interlock)
set(CPACK_PACKAGE_CONTACT "The Interlock developers")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL interlock dev python)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# Libraries by what the files are linked with, those of these packages by name.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/lib)

# The packages in a section of packages.txt, the one list of what is needed, as "a, b, c".
function(packages_of_section section result)
  file(STRINGS ${PROJECT_SOURCE_DIR}/packages.txt lines ENCODING UTF-8)
  set(found "")
  set(inside FALSE)
  foreach(line IN LISTS lines)
    if(line MATCHES "^# (.*)")
      string(COMPARE EQUAL "${CMAKE_MATCH_1}" "${section}" inside)
    elseif(inside AND line MATCHES "^([a-z0-9.+-]+)")
      list(APPEND found ${CMAKE_MATCH_1})
    endif()
  endforeach()
  list(JOIN found ", " found)
  set(${result} "${found}" PARENT_SCOPE)
endfunction()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/packages.txt)
packages_of_section("Running and drawing" for_drawing)
packages_of_section("Libraries" for_building)

set(CPACK_DEBIAN_INTERLOCK_PACKAGE_NAME interlock)
set(CPACK_DEBIAN_INTERLOCK_DESCRIPTION "Pull-out tests of geogrids in railway ballast
 Stones are clumps of spheres, the geogrid is a lattice of beams; both exchange
 contact forces in one loop (discrete and finite elements).")
set(CPACK_DEBIAN_INTERLOCK_PACKAGE_RECOMMENDS "${for_drawing}")
set(CPACK_DEBIAN_INTERLOCK_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/triggers)
file(WRITE ${PROJECT_BINARY_DIR}/triggers "activate-noawait ldconfig\n")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libinterlock-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_DESCRIPTION "Headers and libraries of Interlock
 For find_package(Interlock) of CMake: Interlock::dem, Interlock::fem and
 Interlock::coupling.")
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "interlock (= ${PROJECT_VERSION}), ${for_building}")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-interlock)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "Interlock as a module of Python
 Clumps, runs and their results: import interlock.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "interlock (= ${PROJECT_VERSION}), python3, python3-numpy")

include(CPack)
