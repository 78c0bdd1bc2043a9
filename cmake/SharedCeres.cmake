# Debian's CMake package of Ceres names its static library. Templates of Eigen that were compiled
# into it for the plain processor would be merged, symbol by symbol, with ours for -march=native,
# which align their vectors otherwise; that crashes. The shared library keeps its own to itself.
find_library(NACRE_CERES_LIBRARY
  ${CMAKE_SHARED_LIBRARY_PREFIX}ceres${CMAKE_SHARED_LIBRARY_SUFFIX} REQUIRED)
get_target_property(nacre_ceres_configurations Ceres::ceres IMPORTED_CONFIGURATIONS)
foreach(configuration IN LISTS nacre_ceres_configurations)
  set_target_properties(Ceres::ceres PROPERTIES
    IMPORTED_LOCATION_${configuration} "${NACRE_CERES_LIBRARY}")
endforeach()
