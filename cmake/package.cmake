# `cpack` in the build folder builds a .deb. `apt-get install ./lumaknot_*.deb` also installs its
# dependencies and the small programs to compare with, but not Blender and POV-Ray.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME lumaknot)
set(CPACK_PACKAGE_CONTACT "The lumaknot authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "torus-knot test meshes, luma lighting, and proof that renderers agree")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
    "glslang-tools, gnuplot-nox, libegl1, libgl1, libgl1-mesa-dri, libgles2, libvulkan1, mesa-vulkan-drivers")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "blender, povray, xvfb")
include(CPack)
