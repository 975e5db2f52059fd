# How the libraries and programs of a package are built (VOUSSOIR_PACKAGE). What goes where: VoussoirInstall.cmake.

include(GNUInstallDirs)

set(voussoir_installed_libraries dda records patterns obj mesh exact)
set(voussoir_library_version VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})  # before 1.0 a minor version may change the interface
set(voussoir_library_folder ${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR})

# voussoir_shared(TARGET): what a shared library needs so that code in it is its own. Calls within it stay within it,
# also of the inline functions that it shares with programs compiled for another instruction set.
function(voussoir_shared target)
  set(script ${CMAKE_SOURCE_DIR}/scripts/cmake/voussoir.map)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
  target_link_options(${target} PRIVATE -Wl,-Bsymbolic-functions -Wl,--version-script=${script})
  set_target_properties(${target} PROPERTIES ${voussoir_library_version} INSTALL_RPATH "$ORIGIN"
                        LIBRARY_OUTPUT_DIRECTORY ${voussoir_library_folder} LINK_DEPENDS ${script})
endfunction()

# voussoir_shared_for_v3(NAME): the library NAME of the calling folder once more, for x86-64-v3 (AVX2, FMA: most machines
# since 2015), under the same name in the folder where the loader of glibc looks first on such a machine.
function(voussoir_shared_for_v3 name)
  set(target voussoir_${name}_v3)
  get_target_property(sources voussoir_${name} SOURCES)
  get_target_property(libraries voussoir_${name} LINK_LIBRARIES)
  get_target_property(folders voussoir_${name} INCLUDE_DIRECTORIES)
  add_library(${target} SHARED ${sources})
  target_link_libraries(${target} PRIVATE ${libraries})
  target_include_directories(${target} PRIVATE ${folders})
  target_compile_options(${target} PRIVATE ${voussoir_v3})
  voussoir_shared(${target})
  voussoir_precompile(${target})
  voussoir_unite(${target})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME voussoir_${name}
                        LIBRARY_OUTPUT_DIRECTORY ${voussoir_library_folder}/glibc-hwcaps/x86-64-v3)
  add_dependencies(programs ${target})
  install(TARGETS ${target} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibc-hwcaps/x86-64-v3 NAMELINK_SKIP)
endfunction()

# voussoir_install_program(NAME): `voussoir` among the programs, its helpers in a folder of their own.
set(voussoir_helper_folder ${CMAKE_INSTALL_LIBEXECDIR}/voussoir)
file(RELATIVE_PATH voussoir_helpers_from_program /${CMAKE_INSTALL_BINDIR} /${voussoir_helper_folder})
function(voussoir_install_program name)
  set(folder ${voussoir_helper_folder})
  if(name STREQUAL voussoir)
    set(folder ${CMAKE_INSTALL_BINDIR})
  endif()
  file(RELATIVE_PATH libraries /${folder} /${CMAKE_INSTALL_LIBDIR})
  set_target_properties(${name} PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries}")
  install(TARGETS ${name} RUNTIME DESTINATION ${folder})
endfunction()
