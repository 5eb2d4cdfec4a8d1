# What `cmake --install` puts where. The program and what it loads or starts lie together in a folder of
# their own, where /proc/self/exe leads from the link in bin: so any prefix works, and moving it.
include(GNUInstallDirs)
set(together ${CMAKE_INSTALL_LIBDIR}/lumaknot)
set(made ${PROJECT_BINARY_DIR}/installed)

install(TARGETS lumaknot lumaknot-gpu RUNTIME DESTINATION ${together})
install(TARGETS lumaknot-images LIBRARY DESTINATION ${together})
if(TARGET lumaknot-embree)
  install(TARGETS lumaknot-embree RUNTIME DESTINATION ${together})
endif()
file(RELATIVE_PATH program /${CMAKE_INSTALL_BINDIR} /${together}/lumaknot)
file(MAKE_DIRECTORY ${made})
file(CREATE_LINK ${program} ${made}/lumaknot SYMBOLIC)
install(FILES ${made}/lumaknot DESTINATION ${CMAKE_INSTALL_BINDIR})

install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES docs/scene.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/lumaknot)

# What the program prints about itself: completion scripts and manual pages.
add_custom_command(
  OUTPUT ${made}/lumaknot.bash ${made}/_lumaknot ${made}/lumaknot.fish ${made}/man1/lumaknot.1
  COMMAND lumaknot completion bash > ${made}/lumaknot.bash
  COMMAND lumaknot completion zsh > ${made}/_lumaknot
  COMMAND lumaknot completion fish > ${made}/lumaknot.fish
  COMMAND lumaknot man -o ${made}/man1
  VERBATIM)
add_custom_target(lumaknot-printed ALL DEPENDS ${made}/lumaknot.bash)
install(FILES ${made}/lumaknot.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME lumaknot)
# Debian's zsh looks into the one below /usr, into the other below /usr/local.
foreach(folder IN ITEMS site-functions vendor-completions)
  install(FILES ${made}/_lumaknot DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${folder})
endforeach()
install(FILES ${made}/lumaknot.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(DIRECTORY ${made}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
