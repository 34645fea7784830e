# With CMAKE_UNITY_BUILD sources are compiled some at a time, as most of the time goes into headers: those of the
# library by rooms. Names are therefore unique in a room, also those that only one source sees. The largest takes
# 2.3 GB of memory; rooms together would take more, and hardly less time.
set(CMAKE_UNITY_BUILD_BATCH_SIZE 96)
if(CMAKE_UNITY_BUILD)
  # GCC would look for garbage from some 100 MB on, which takes a tenth of its time [kB].
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=700000>)
endif()

function(higherpair_unite_rooms target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    if(source MATCHES "^${PROJECT_SOURCE_DIR}/src/([a-z]+)/([a-z]+/)?[a-z_0-9]+\\.cpp$")
      set(room ${CMAKE_MATCH_1})
      list(APPEND rooms_${room} ${source})
      list(LENGTH rooms_${room} count)
      math(EXPR group "(${count} - 1) / ${CMAKE_UNITY_BUILD_BATCH_SIZE}")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${room}_${group})
    endif()
  endforeach()
  if(CMAKE_UNITY_BUILD)
    # GCC lets what it compiles at once grow by less than a half through inlining, where that is large: the steps of a
    # run would be slower than if each source was compiled alone. With more inlined version 12 sees Boost's numbers
    # read beyond their end.
    target_compile_options(${target} PRIVATE
      $<$<CXX_COMPILER_ID:GNU>:--param=large-unit-insns=1000000;-Wno-stringop-overread>)
  endif()
endfunction()
