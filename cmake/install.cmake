# The layout that `cmake --install` creates. The program and everything it loads or starts share one
# folder, which it finds by /proc/self/exe through the link in bin, so the prefix is free and movable.
include(GNUInstallDirs)
set(program_folder ${CMAKE_INSTALL_LIBDIR}/lumaknot)
set(generated ${PROJECT_BINARY_DIR}/installed)

install(TARGETS lumaknot lumaknot-gpu RUNTIME DESTINATION ${program_folder})
install(TARGETS lumaknot-images LIBRARY DESTINATION ${program_folder})
if(TARGET lumaknot-embree)
  install(TARGETS lumaknot-embree RUNTIME DESTINATION ${program_folder})
endif()
file(RELATIVE_PATH program /${CMAKE_INSTALL_BINDIR} /${program_folder}/lumaknot)
file(MAKE_DIRECTORY ${generated})
file(CREATE_LINK ${program} ${generated}/lumaknot SYMBOLIC)
install(FILES ${generated}/lumaknot DESTINATION ${CMAKE_INSTALL_BINDIR})

install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES docs/scene.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/lumaknot)

# Completion scripts and manual pages, printed by the program itself.
add_custom_command(
  OUTPUT ${generated}/lumaknot.bash ${generated}/_lumaknot ${generated}/lumaknot.fish ${generated}/man1/lumaknot.1
  COMMAND lumaknot completion bash > ${generated}/lumaknot.bash
  COMMAND lumaknot completion zsh > ${generated}/_lumaknot
  COMMAND lumaknot completion fish > ${generated}/lumaknot.fish
  COMMAND lumaknot man -o ${generated}/man1
  DEPENDS lumaknot
  VERBATIM)
add_custom_target(lumaknot-printed ALL DEPENDS ${generated}/lumaknot.bash)
install(FILES ${generated}/lumaknot.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME lumaknot)
# Debian's zsh reads vendor-completions below /usr and site-functions below /usr/local.
foreach(folder IN ITEMS site-functions vendor-completions)
  install(FILES ${generated}/_lumaknot DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${folder})
endforeach()
install(FILES ${generated}/lumaknot.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(DIRECTORY ${generated}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
