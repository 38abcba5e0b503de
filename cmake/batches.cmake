# boxbeam_batches(TARGET SIZE): compiles the sources of a folder in batches of at most SIZE, each as one
# file: what is included is read once a batch. For builds from scratch; a change in one source compiles
# its batch again. Batches do not cross folders, so that names of one module stay out of the others.
# What follows SIZE is compiled alone: it means something else by a name of its neighbours.
function(boxbeam_batches target size)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    if(NOT source MATCHES "\\.cpp$" OR source IN_LIST ARGN)
      continue()
    endif()
    get_filename_component(folder ${source} DIRECTORY)
    string(MAKE_C_IDENTIFIER "${folder}" id)
    if(NOT DEFINED count_${id})
      set(count_${id} 0)
    endif()
    math(EXPR batch "${count_${id}} / ${size}")
    math(EXPR count_${id} "${count_${id}} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${id}_${batch}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
