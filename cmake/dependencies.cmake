# The libraries lumaknot is built with and their Debian packages. Everything missing or too old is
# reported in one message, with the command that installs it.
include_guard()
set(missing "")
set(why "")

# lumaknot_find(PACKAGE MODULE [VERSION]): a library with CMake files. The version is compared here, as
# some of those files treat a newer major version as incompatible.
macro(lumaknot_find package module)
  find_package(${module} QUIET CONFIG)
  lumaknot_check(${package} ${module} "${ARGN}")
endmacro()

# lumaknot_find_pc(PACKAGE MODULE [VERSION]): a library found by pkg-config, as PkgConfig::MODULE,
# because it has no CMake files or they require too much (OpenImageIO's: its tools and Python's Imath).
macro(lumaknot_find_pc package module)
  pkg_check_modules(${module} QUIET IMPORTED_TARGET ${module})
  lumaknot_check(${package} ${module} "${ARGN}")
endmacro()

# lumaknot_find_header(PACKAGE TARGET HEADER): a header-only library, as TARGET.
macro(lumaknot_find_header package target header)
  find_path(${target}_INCLUDE ${header})
  set(${target}_FOUND ${${target}_INCLUDE})
  lumaknot_check(${package} ${target} "")
  add_library(${target} INTERFACE IMPORTED)
  if(${target}_FOUND)
    target_include_directories(${target} SYSTEM INTERFACE ${${target}_INCLUDE})
  endif()
endmacro()

macro(lumaknot_check package name version)
  if(NOT ${name}_FOUND)
    list(APPEND missing ${package})
    list(APPEND why "  ${name} ${version}: not found (${package})")
  elseif(DEFINED ${name}_VERSION AND "${${name}_VERSION}" VERSION_LESS "${version}")
    list(APPEND missing ${package})
    list(APPEND why "  ${name} ${version}: too old, ${${name}_VERSION} (${package})")
  endif()
endmacro()

find_package(PkgConfig QUIET)
if(NOT PkgConfig_FOUND)
  message(FATAL_ERROR "pkg-config not found; install with: apt-get install pkg-config")
endif()

lumaknot_find(libboost-dev Boost 1.74)
lumaknot_find(libcli11-dev CLI11 2.1)
lumaknot_find(libfmt-dev fmt 9)
lumaknot_find(nlohmann-json3-dev nlohmann_json 3.11)
lumaknot_find(libopenmesh-dev OpenMesh 9)
lumaknot_find(libtbb-dev TBB 2021)
lumaknot_find(libxsimd-dev xsimd)
lumaknot_find(libspirv-cross-c-shared-dev spirv_cross_core)
lumaknot_find_pc(libopenimageio-dev OpenImageIO 2.4)
lumaknot_find_pc(libgmp-dev gmpxx)
lumaknot_find_pc(libepoxy-dev epoxy 1.5)
lumaknot_find_pc(spirv-tools SPIRV-Tools)
lumaknot_find_header(libkainjow-mustache-dev mustache kainjow/mustache.hpp)
lumaknot_find_header(libvulkan-dev vulkan_headers vulkan/vulkan_raii.hpp)
if(LUMAKNOT_TESTS)
  lumaknot_find(libgmock-dev GTest)
  find_package(Python3 QUIET)
  lumaknot_check(python3 Python3 "")
endif()
if(LUMAKNOT_BENCH)
  lumaknot_find(libbenchmark-dev benchmark)
endif()

if(missing)
  list(JOIN missing " " missing)
  list(JOIN why "\n" why)
  message(FATAL_ERROR "Libraries needed to build lumaknot are missing or too old:\n${why}\n"
                      "Install with: apt-get install ${missing}")
endif()
