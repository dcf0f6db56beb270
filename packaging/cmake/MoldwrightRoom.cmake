# moldwright_room(NAME SOURCES a.cpp … [USES room …] [PUBLIC lib …] [PRIVATE lib …])
# One room of the core: a static library moldwright_NAME that sees the rooms it USES and no others.
function(moldwright_room name)
    cmake_parse_arguments(ARG "" "" "SOURCES;USES;PUBLIC;PRIVATE" ${ARGN})
    set(target moldwright_${name})
    add_library(${target} STATIC ${ARG_SOURCES})
    list(TRANSFORM ARG_USES PREPEND moldwright_)
    target_link_libraries(${target} PUBLIC ${ARG_USES} ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} moldwright_warnings)
    target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/core)
endfunction()

# moldwright_test(NAME SOURCES a_test.cpp … LINKS lib … [LABELS l …] [WINDOW])
# One GoogleTest program; every TEST in it becomes one CTest entry.
function(moldwright_test name)
    cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LINKS;LABELS" ${ARGN})
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 300)
    endif()
    add_executable(${name} ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE ${ARG_LINKS} moldwright_test_support GTest::gtest GTest::gtest_main
        moldwright_warnings)
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 TEST_PREFIX ${name}. PROPERTIES TIMEOUT ${ARG_TIMEOUT}
        LABELS "${ARG_LABELS}")
endfunction()
