# What `cmake --install` copies: the program, the headers, one static library per folder, the data
# and recipes, and a CMake package, so that another project can say
#
#   find_package(nacre REQUIRED)
#   target_link_libraries(app PRIVATE nacre::solver)
#
# cmake/consumer is such a project; cmake/consumer/check.sh builds and runs it.
include(CMakePackageConfigHelpers)

set(NACRE_INSTALL_CMAKEDIR "${CMAKE_INSTALL_LIBDIR}/cmake/nacre")
set(NACRE_INSTALL_DATADIR "${CMAKE_INSTALL_DATADIR}/nacre")

function(nacre_install)
  get_property(modules GLOBAL PROPERTY NACRE_MODULES)
  install(TARGETS nacre_options ${modules} EXPORT nacre
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(TARGETS nacre RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(EXPORT nacre NAMESPACE nacre:: DESTINATION ${NACRE_INSTALL_CMAKEDIR}
          FILE nacre-targets.cmake)

  configure_package_config_file(
    ${PROJECT_SOURCE_DIR}/cmake/nacre-config.cmake.in ${PROJECT_BINARY_DIR}/nacre-config.cmake
    INSTALL_DESTINATION ${NACRE_INSTALL_CMAKEDIR} PATH_VARS NACRE_INSTALL_DATADIR)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/nacre-config-version.cmake
                                   COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/nacre-config.cmake
                ${PROJECT_BINARY_DIR}/nacre-config-version.cmake
                ${PROJECT_SOURCE_DIR}/cmake/SharedCeres.cmake
          DESTINATION ${NACRE_INSTALL_CMAKEDIR})

  install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/nacre DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          FILES_MATCHING PATTERN "*.h" PATTERN "testing" EXCLUDE)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/data ${PROJECT_SOURCE_DIR}/paints
                    ${PROJECT_SOURCE_DIR}/scenes ${PROJECT_SOURCE_DIR}/studies
          DESTINATION ${NACRE_INSTALL_DATADIR})
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CITATION.cff
          DESTINATION ${CMAKE_INSTALL_DOCDIR})
endfunction()
