# The options shared by all targets.
add_library(lumaknot_options INTERFACE)
target_include_directories(lumaknot_options INTERFACE ${PROJECT_SOURCE_DIR})
# One rounding per operation, as written, so that the output does not depend on contraction.
target_compile_options(lumaknot_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow
                                                  -Wconversion -Wno-sign-conversion -ffp-contract=off)
# GCC 12.2 drops the rounding of double(float(x)) when it vectorizes two of them: {float(x), float(y)}
# as doubles become x and y.
target_compile_options(lumaknot_options INTERFACE -fno-tree-slp-vectorize)
if(LUMAKNOT_WARNINGS_AS_ERRORS)
  # GCC 12 warns about vectors in OpenMesh's headers at -O1.
  target_compile_options(
    lumaknot_options INTERFACE -Werror $<$<CXX_COMPILER_ID:GNU>:-Wno-error=maybe-uninitialized>)
endif()
if(LUMAKNOT_SANITIZE)
  # Null pointers, sizes of objects and virtual tables are left to the address sanitizer, and to
  # processors, which trap: checking them as well takes a fifth of the compiler's time.
  # GCC 12 mistakes the sanitizers' checks for uses of uninitialised values.
  target_compile_options(
    lumaknot_options INTERFACE -fsanitize=address,undefined -fno-sanitize=null,object-size,vptr
                               -fno-sanitize-recover=all
                               $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(lumaknot_options INTERFACE -fsanitize=address,undefined)
endif()

# lumaknot_optimize(TARGET LEVEL): the level in Release for code that does not need -O3. The results do
# not change, as every level rounds alike.
function(lumaknot_optimize target level)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${level}>)
endfunction()

# lumaknot_memory_only(TARGET): of the sanitizers it has the address sanitizer alone, which halves the time
# to compile it: for code that bad input and untrusted sizes don't reach.
function(lumaknot_memory_only target)
  if(LUMAKNOT_SANITIZE)
    target_compile_options(${target} PRIVATE -fno-sanitize=undefined)
  endif()
endfunction()

# lumaknot_unity(TARGET): compiles its files twenty at a time, in order. Names in unnamed namespaces
# must differ within a namespace.
function(lumaknot_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${LUMAKNOT_UNITY} UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  set(files 0)
  foreach(source IN LISTS sources)
    math(EXPR batch "${files} / 20")
    math(EXPR files "${files} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${batch})
  endforeach()
endfunction()

# lumaknot_library(NAME [UNITY] [OPTIMIZE level] [FOLDERS folders...] PUBLIC libs... PRIVATE libs...): the
# folder NAME and the given subfolders as lumaknot::NAME.
function(lumaknot_library name)
  cmake_parse_arguments(ARG "UNITY" "OPTIMIZE" "FOLDERS;PUBLIC;PRIVATE" ${ARGN})
  set(patterns *.cpp *.h)
  foreach(folder IN LISTS ARG_FOLDERS)
    list(APPEND patterns ${folder}/*.cpp ${folder}/*.h)
  endforeach()
  file(GLOB sources CONFIGURE_DEPENDS ${patterns})
  add_library(lumaknot_${name} STATIC ${sources})
  add_library(lumaknot::${name} ALIAS lumaknot_${name})
  target_link_libraries(lumaknot_${name} PUBLIC lumaknot_options ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  if(ARG_OPTIMIZE)
    lumaknot_optimize(lumaknot_${name} ${ARG_OPTIMIZE})
  endif()
  if(ARG_UNITY)
    lumaknot_unity(lumaknot_${name})
  endif()
endfunction()

# lumaknot_embed(target file symbol): the text of `file` as lumaknot::embedded::symbol().
function(lumaknot_embed target file symbol)
  set(source ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/embedded_${symbol}.cpp)
  add_custom_command(
    OUTPUT ${generated}
    COMMAND ${CMAKE_COMMAND} -DSOURCE=${source} -DOUTPUT=${generated} -DSYMBOL=${symbol} -P
            ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${source} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    VERBATIM)
  target_sources(${target} PRIVATE ${generated})
endfunction()
