# What `cmake --install` and `cpack` put where. How it is built: VoussoirPackage.cmake. docs/embedding.md tells of both.

if(NOT VOUSSOIR_PACKAGE)
  install(CODE "message(FATAL_ERROR \"This build is for its own machine and for tests. What can be installed is built by: \
cmake --preset package && cmake --build --preset package && cmake --install build/package --prefix DIR\")")
  return()
endif()

# Headers: one a library names its surface; it and what it includes are installed, under an include root of their own.
set(voussoir_include ${CMAKE_INSTALL_INCLUDEDIR}/voussoir)
# voussoir_install_headers(HEADER NAME): HEADER as <voussoir/NAME>, and all it includes under the paths it includes them by.
function(voussoir_install_headers header name)
  install(FILES ${CMAKE_SOURCE_DIR}/${header} DESTINATION ${voussoir_include} RENAME ${name})
  set(found)
  set(open ${header})
  while(open)
    list(POP_FRONT open next)
    if(next IN_LIST found)
      continue()
    endif()
    list(APPEND found ${next})
    set_property(DIRECTORY ${CMAKE_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${next})
    file(STRINGS ${CMAKE_SOURCE_DIR}/${next} includes REGEX "^#include \"")
    list(TRANSFORM includes REPLACE "^#include \"([^\"]+)\".*" "\\1")
    list(APPEND open ${includes})
    if(NOT next STREQUAL header)
      get_filename_component(folder ${next} DIRECTORY)
      install(FILES ${CMAKE_SOURCE_DIR}/${next} DESTINATION ${voussoir_include}/${folder})
    endif()
  endwhile()
endfunction()
voussoir_install_headers(libdda/voussoir.h voussoir.h)
voussoir_install_headers(records/records.h records.h)
set(libraries dda records patterns obj)
if(VOUSSOIR_GEOMETRY)
  voussoir_install_headers(importers/importers.h importers.h)
  list(APPEND libraries mesh exact importers)
endif()

# Libraries, and what find_package(voussoir) reads.
foreach(library ${libraries})
  set_target_properties(voussoir_${library} PROPERTIES EXPORT_NAME ${library})
  install(TARGETS voussoir_${library} EXPORT voussoir LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endforeach()
target_include_directories(voussoir_dda INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
                           $<INSTALL_INTERFACE:${voussoir_include}>)
target_compile_definitions(voussoir_dda INTERFACE $<INSTALL_INTERFACE:${voussoir_alignment}>)
target_compile_features(voussoir_dda INTERFACE cxx_std_20)

include(CMakePackageConfigHelpers)
set(voussoir_config ${CMAKE_INSTALL_LIBDIR}/cmake/voussoir)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/voussoirConfig.cmake.in voussoirConfig.cmake
                              INSTALL_DESTINATION ${voussoir_config})
write_basic_package_version_file(voussoirConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/voussoirConfig.cmake ${CMAKE_BINARY_DIR}/voussoirConfigVersion.cmake
        DESTINATION ${voussoir_config})
install(EXPORT voussoir NAMESPACE voussoir:: FILE voussoirTargets.cmake DESTINATION ${voussoir_config})

# The manual and what the shell completes, from the program's own --help.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(manual ${CMAKE_BINARY_DIR}/manual)
add_custom_command(OUTPUT ${manual}/completions/voussoir
  COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/scripts/make_manual.py $<TARGET_FILE:voussoir> ${manual}
  DEPENDS voussoir ${CMAKE_SOURCE_DIR}/scripts/make_manual.py VERBATIM)
add_custom_target(manual ALL DEPENDS ${manual}/completions/voussoir)
install(DIRECTORY ${manual}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
install(FILES ${manual}/completions/voussoir DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)

# Cases, the schema of case files, documents.
install(DIRECTORY cases DESTINATION ${CMAKE_INSTALL_DATADIR}/voussoir)
install(FILES docs/case.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/voussoir)
install(FILES app/results/python/voussoir_results.py DESTINATION ${CMAKE_INSTALL_DATADIR}/voussoir/python)
install(DIRECTORY docs/examples DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES README.md docs/embedding.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)

# The Debian package: everything in one. dpkg-shlibdeps finds the libraries; the font is asked for by name only.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the maintainers of voussoir")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${voussoir_library_folder})
if(VOUSSOIR_RENDER)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS fonts-dejavu-core)
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS ffmpeg)  # films
endif()
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cmake, libeigen3-dev")
include(CPack)
