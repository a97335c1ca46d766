# The program beside an ORB-SLAM that is built already: included by ../orb_slam2 and ../orb_slam3.
# Needs host_root, host_library, host_flags and host_includes.
if(NOT EXISTS ${host_root}/include/SemanticHooks.h)
  message(FATAL_ERROR "Its root has to be a source folder with the hooks of README.md.")
endif()
foreach(built lib/${host_library} Thirdparty/DBoW2/lib/libDBoW2.so Thirdparty/g2o/lib/libg2o.so)
  if(NOT EXISTS ${host_root}/${built})
    message(FATAL_ERROR "${host_root}/${built} is not there: the host has to be built first, see README.md.")
  endif()
endforeach()
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

set(TOPOBAG_BUILD_TESTS OFF)
set(TOPOBAG_BUILD_EXAMPLES OFF)
set(TOPOBAG_BUILD_BENCHMARKS OFF)
add_subdirectory(${CMAKE_CURRENT_LIST_DIR}/../.. topobag)
find_package(CLI11 REQUIRED)
find_package(OpenCV 4.5 REQUIRED COMPONENTS core imgproc imgcodecs features2d calib3d dnn)
find_package(Pangolin QUIET)
if(NOT Pangolin_FOUND AND NOT host_includes)
  message(FATAL_ERROR "Pangolin, which the host's headers include, is not found: name the folder of PangolinConfig.cmake with "
    "-DPangolin_DIR.")
endif()
find_package(Threads REQUIRED)

set(shared ${CMAKE_CURRENT_LIST_DIR})
set(program ${CMAKE_CURRENT_LIST_DIR}/../topobag)
include(${shared}/table_sources.cmake)
add_executable(rgbd_tum_semantic ${shared}/rgbd_tum_semantic.cpp ${shared}/semantic_slam.cpp ${table_sources})
target_include_directories(rgbd_tum_semantic PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${shared} ${program})
target_include_directories(rgbd_tum_semantic SYSTEM PRIVATE
  ${host_root} ${host_root}/include ${host_includes} ${Pangolin_INCLUDE_DIRS})
separate_arguments(flags NATIVE_COMMAND "${host_flags}")
target_compile_options(rgbd_tum_semantic PRIVATE ${flags} -Wall -Wextra -Wpedantic -Wshadow -Wno-maybe-uninitialized
  -Wno-uninitialized -Wno-array-bounds)  # all of what g++ 12 says of its own headers of AVX-512
target_link_libraries(rgbd_tum_semantic PRIVATE topobag::opencv CLI11::CLI11 Threads::Threads
  ${host_root}/lib/${host_library} ${host_root}/Thirdparty/DBoW2/lib/libDBoW2.so
  ${host_root}/Thirdparty/g2o/lib/libg2o.so ${OpenCV_LIBS} ${Pangolin_LIBRARIES})
