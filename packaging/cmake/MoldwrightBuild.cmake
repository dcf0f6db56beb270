# How every target of Moldwright is compiled and linked.

set(CMAKE_CXX_STANDARD 23)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()

option(MOLDWRIGHT_ASSERTIONS "Keep assertions in optimised builds" OFF)
set(MOLDWRIGHT_SANITIZE "" CACHE STRING "Sanitizers, as in -fsanitize=...")

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()
find_program(MOLD_LINKER mold)
if(MOLD_LINKER)
    add_link_options(-fuse-ld=mold)
endif()

# -ffp-contract=off: the same bits from vectorised and plain code paths of one source line.
add_compile_options(-ffp-contract=off)
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g1 -DNDEBUG")
if(MOLDWRIGHT_ASSERTIONS)
    set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g1 -D_GLIBCXX_ASSERTIONS")
endif()
if(MOLDWRIGHT_SANITIZE)
    add_compile_options(-fsanitize=${MOLDWRIGHT_SANITIZE} -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${MOLDWRIGHT_SANITIZE})
endif()

# Units that instantiate CGAL need 2 GB each: one at a time.
set_property(GLOBAL PROPERTY JOB_POOLS cgal_pool=1)

add_library(moldwright_warnings INTERFACE)
target_compile_options(moldwright_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
    -Woverloaded-virtual -Werror
    # g++ 12 reports this inside Eigen and OpenMesh where nothing is uninitialised.
    -Wno-maybe-uninitialized)
