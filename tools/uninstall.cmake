# SPDX-License-Identifier: MIT
#
# Takes away what `cmake --install` wrote down, and folders of ours that are empty then; `include` is the folder of
# headers.
file(STRINGS "${CMAKE_BINARY_DIR}/install_manifest.txt" files)
foreach(file IN LISTS files)
   file(REMOVE "$ENV{DESTDIR}${file}")
   get_filename_component(folder "${file}" DIRECTORY)
   while(folder MATCHES "/(${include}|cmake|licenses)/furiko(/[^/]*)?$")
      file(GLOB left "$ENV{DESTDIR}${folder}/*")
      if(NOT left)
         file(REMOVE_RECURSE "$ENV{DESTDIR}${folder}")
      endif()
      get_filename_component(folder "${folder}" DIRECTORY)
   endwhile()
endforeach()
