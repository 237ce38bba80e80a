# SPDX-License-Identifier: GPL-3.0-or-later
# One interface target carries the language level, the warnings and the sanitizers; every target
# of ours links it, so that nothing is set by folder or by accident.
add_library(trex_options INTERFACE)
target_compile_features(trex_options INTERFACE cxx_std_20)
target_include_directories(trex_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_definitions(trex_options INTERFACE
    QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII QT_NO_FOREACH
    QT_NO_NARROWING_CONVERSIONS_IN_CONNECT QT_DISABLE_DEPRECATED_BEFORE=0x060400)
target_compile_options(trex_options INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
    -Wold-style-cast -Wimplicit-fallthrough $<$<CONFIG:Release,RelWithDebInfo>:-D_FORTIFY_SOURCE=2>
    -fstack-protector-strong)
if(TREX_WERROR)
    target_compile_options(trex_options INTERFACE -Werror)
endif()
if(TREX_SANITIZE)
    target_compile_options(trex_options INTERFACE -fsanitize=${TREX_SANITIZE} -fno-omit-frame-pointer
                           -fno-sanitize-recover=all)
    target_link_options(trex_options INTERFACE -fsanitize=${TREX_SANITIZE})
endif()
if(TREX_COVERAGE)
    target_compile_options(trex_options INTERFACE --coverage)
    target_link_options(trex_options INTERFACE --coverage)
endif()

# ccache is used where it is installed; nothing depends on it.
find_program(TREX_CCACHE ccache)
if(TREX_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${TREX_CCACHE})
endif()
set(CMAKE_AUTOMOC ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
