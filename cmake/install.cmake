# What `cmake --install` puts where. The program and what it loads or starts lie together in a folder of
# their own, where /proc/self/exe leads from the link in bin: so any prefix works, and moving it.
include(GNUInstallDirs)
set(together ${CMAKE_INSTALL_LIBDIR}/lumaknot)
install(TARGETS lumaknot lumaknot-gpu lumaknot-images RUNTIME DESTINATION ${together}
                                                      LIBRARY DESTINATION ${together})
if(TARGET lumaknot-embree)
  install(TARGETS lumaknot-embree RUNTIME DESTINATION ${together})
endif()
set(made ${PROJECT_BINARY_DIR}/installed)
file(RELATIVE_PATH program /${CMAKE_INSTALL_BINDIR} /${together}/lumaknot)
file(MAKE_DIRECTORY ${made})
file(CREATE_LINK ${program} ${made}/lumaknot SYMBOLIC)
install(FILES ${made}/lumaknot DESTINATION ${CMAKE_INSTALL_BINDIR})

install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES docs/scene.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/lumaknot)

# lumaknot_completion(SHELL FILE FOLDER): the shell's completion script, printed by the program.
set(completions "")
function(lumaknot_completion shell file folder)
  add_custom_command(
    OUTPUT ${made}/${shell}/${file}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${made}/${shell}
    COMMAND lumaknot completion ${shell} > ${made}/${shell}/${file}
    VERBATIM)
  install(FILES ${made}/${shell}/${file} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder})
  list(APPEND completions ${made}/${shell}/${file})
  return(PROPAGATE completions)
endfunction()
