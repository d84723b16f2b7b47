# Build-wide options: build types, sanitizers, determinism.

option(SCARAB_BUILD_TESTS "Build tests and benchmarks" ON)
set(SCARAB_SANITIZE "" CACHE STRING "Sanitizers to build with, such as address,undefined or thread")

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# Debian built Simbody without NDEBUG; a client that defines it crashes in realizeTopology(). CMake's own
# Release and RelWithDebInfo define it, so both are spelled out here.
set(CMAKE_CXX_FLAGS_RELEASE "-O3")
set(CMAKE_C_FLAGS_RELEASE "-O3")
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g")
set(CMAKE_C_FLAGS_RELWITHDEBINFO "-O2 -g")

# Samples are compared byte by byte between processes and compositions: no contraction, no fast-math.
add_compile_options(-ffp-contract=off)

if(SCARAB_SANITIZE)
  add_compile_options(-fsanitize=${SCARAB_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${SCARAB_SANITIZE})
  # Eigen allocates otherwise where it sees the sanitizer, and libpagmo, which was built without, frees it.
  add_compile_definitions(EIGEN_MALLOC_ALREADY_ALIGNED=1)
  # GCC 12 sees uninitialised reads inside its own <regex> and <variant> once they are instrumented.
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-Wno-maybe-uninitialized>)
endif()

find_program(SCARAB_CCACHE ccache)
if(SCARAB_CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER ${SCARAB_CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${SCARAB_CCACHE})
endif()
