# What `cmake --install` copies: the program, the headers, one static library per folder, the data
# and recipes, and a CMake package, so that another project can say
#
#   find_package(nacre REQUIRED COMPONENTS core)
#   target_link_libraries(app PRIVATE nacre::nacre)
#
# Component `core` is everything but ray tracing; `render` adds it, and with it Embree and assimp.
# examples/ is such a project; examples/check.sh builds and runs it against an installed copy.
include(CMakePackageConfigHelpers)

set(NACRE_INSTALL_CMAKEDIR "${CMAKE_INSTALL_LIBDIR}/cmake/nacre")
set(NACRE_INSTALL_DATADIR "${CMAKE_INSTALL_DATADIR}/nacre")

function(nacre_install)
  get_property(core_modules GLOBAL PROPERTY NACRE_MODULES_core)
  get_property(render_modules GLOBAL PROPERTY NACRE_MODULES_render)
  install(TARGETS nacre_options ${core_modules} EXPORT nacre-core
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(TARGETS ${render_modules} EXPORT nacre-render
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  foreach(component IN ITEMS core render)
    install(EXPORT nacre-${component} NAMESPACE nacre:: DESTINATION ${NACRE_INSTALL_CMAKEDIR}
            FILE nacre-${component}-targets.cmake)
  endforeach()
  install(TARGETS nacre RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})

  configure_package_config_file(
    ${PROJECT_SOURCE_DIR}/cmake/nacre-config.cmake.in ${PROJECT_BINARY_DIR}/nacre-config.cmake
    INSTALL_DESTINATION ${NACRE_INSTALL_CMAKEDIR} PATH_VARS NACRE_INSTALL_DATADIR)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/nacre-config-version.cmake
                                   COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/nacre-config.cmake
                ${PROJECT_BINARY_DIR}/nacre-config-version.cmake
                ${PROJECT_SOURCE_DIR}/cmake/SharedCeres.cmake
          DESTINATION ${NACRE_INSTALL_CMAKEDIR})

  # What tests share, and what only our own sources include, stays here.
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/nacre DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          FILES_MATCHING PATTERN "*.h" PATTERN "testing" EXCLUDE PATTERN "api" EXCLUDE
          PATTERN "*test_support.h" EXCLUDE PATTERN "core/embree.h" EXCLUDE
          PATTERN "io/hdf5_file.h" EXCLUDE)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/data ${PROJECT_SOURCE_DIR}/paints
                    ${PROJECT_SOURCE_DIR}/scenes ${PROJECT_SOURCE_DIR}/studies
          DESTINATION ${NACRE_INSTALL_DATADIR})
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CITATION.cff
          DESTINATION ${CMAKE_INSTALL_DOCDIR})
endfunction()
