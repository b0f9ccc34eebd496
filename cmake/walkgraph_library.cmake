# walkgraph_library(NAME DIRECTORIES dir... [DEPENDS target...] [PRIVATE_DEPENDS target...]
#                   [PRECOMPILED header...])
#
# One library from the *.cc and *.h directly in the given directories (relative to the top of the
# repository). Headers are included by their path from the top ("data/recording.h"), but the top is on
# nobody's include path: every library publishes links to its own headers, so that an include compiles
# only where the link target is there too. A library without *.cc is an interface. Headers that most
# files parse, and those named, are precompiled where there are files enough to pay for it.
function(walkgraph_library name)
  cmake_parse_arguments(ARG "" "" "DIRECTORIES;DEPENDS;PRIVATE_DEPENDS;PRECOMPILED" ${ARGN})
  set(include_root ${PROJECT_BINARY_DIR}/include/${name})
  set(sources "")
  set(headers "")
  foreach(directory IN LISTS ARG_DIRECTORIES)
    file(GLOB found_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${directory}/*.cc)
    file(GLOB found_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${directory}/*.h)
    list(APPEND sources ${found_sources})
    list(APPEND headers ${found_headers})
    file(MAKE_DIRECTORY ${include_root}/${directory})
    foreach(header IN LISTS found_headers)
      get_filename_component(file ${header} NAME)
      file(CREATE_LINK ${header} ${include_root}/${directory}/${file} SYMBOLIC)
    endforeach()
  endforeach()
  if(sources)
    add_library(${name} STATIC ${sources} ${headers})
    target_include_directories(${name} PUBLIC ${include_root})
    target_link_libraries(${name} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS})
    list(LENGTH sources files)
    if(files GREATER_EQUAL 8)
      target_precompile_headers(${name} PRIVATE <Eigen/Core> <algorithm> <cmath> <map> <string>
                                <vector> ${ARG_PRECOMPILED})
    endif()
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE ${include_root})
    target_link_libraries(${name} INTERFACE ${ARG_DEPENDS})
  endif()
endfunction()
