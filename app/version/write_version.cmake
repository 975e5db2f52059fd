# cmake -DROOT=... -DVERSION=... -DOUTPUT=... [-DGIT=...] -P write_version.cmake
# Writes what the program is built from to OUTPUT, and leaves the file alone where nothing changed, so that nothing is
# compiled or linked then.
cmake_minimum_required(VERSION 3.25)
set(version ${VERSION})
set(commit "")
set(dirty unknown)

# A checkout of its own: ROOT within the checkout of something else has no commit.
if(GIT)
  set(ENV{GIT_OPTIONAL_LOCKS} 0)  # whoever works in the checkout meanwhile is not disturbed
  execute_process(COMMAND ${GIT} -C ${ROOT} rev-parse --show-cdup OUTPUT_VARIABLE up RESULT_VARIABLE failed ERROR_QUIET)
  string(STRIP "${up}" up)
  if(NOT failed AND up STREQUAL "")
    execute_process(COMMAND ${GIT} -C ${ROOT} rev-parse --verify --quiet HEAD OUTPUT_VARIABLE head RESULT_VARIABLE failed)
    if(NOT failed)
      string(SUBSTRING "${head}" 0 12 commit)
      execute_process(COMMAND ${GIT} -C ${ROOT} status --porcelain --untracked-files=no OUTPUT_VARIABLE changes
                      RESULT_VARIABLE failed)
      if(NOT failed)
        set(dirty no)
        if(changes)
          set(dirty yes)
        endif()
      endif()
    endif()
  endif()
endif()

# `git archive` puts the commit there; whether files were changed afterwards only their checksum can tell.
if(commit STREQUAL "")
  file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/archive_commit.txt archived REGEX "^[0-9a-f]+$" LIMIT_COUNT 1)
  if(archived)
    string(SUBSTRING "${archived}" 0 12 commit)
  endif()
endif()

# What decides a number of a result: the engine, and what makes its model of a case.
set(folders libdda importers records app/case app/reader app/words)
set(patterns)
foreach(folder ${folders})
  list(APPEND patterns ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
endforeach()
file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE ${ROOT} ${patterns})
list(SORT files)
set(checksums "")
foreach(name ${files})
  file(SHA256 ${ROOT}/${name} checksum)
  string(APPEND checksums "${name} ${checksum}\n")
endforeach()
string(SHA256 sources "${checksums}")
string(SUBSTRING ${sources} 0 12 sources)

configure_file(${CMAKE_CURRENT_LIST_DIR}/built_from.cpp.in ${OUTPUT} @ONLY)
