# cmake -DNPM= -DNODE= -DSCRIPT= -DFROM= -DSOURCES= -P bundle.cmake, in a folder of its own: copies the sources there, lets
# npm bring what the lock file names, and bundles. What fails makes an empty script and a message, not a failed build.
set(here ${CMAKE_CURRENT_BINARY_DIR})
foreach(source ${SOURCES})
  configure_file(${FROM}/${source} ${here}/${source} COPYONLY)
endforeach()
execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --prefer-offline --fetch-retries=0 --loglevel=error
                WORKING_DIRECTORY ${here} TIMEOUT 180 RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(failed EQUAL 0)
  execute_process(COMMAND ${NODE} build.mjs ${SCRIPT}
                  WORKING_DIRECTORY ${here} TIMEOUT 180 RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
endif()
if(NOT failed EQUAL 0)
  message("The interactive view of reports could not be bundled, reports will have none (configure again to try again):\n"
          "${said}")
  file(WRITE ${SCRIPT} "")
endif()
