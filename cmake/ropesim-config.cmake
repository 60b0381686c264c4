# find_package(ropesim) gives the program, ropesim::ropesim, and
#
#   ropesim_add_golden_test(NAME SCENE [EXPECTED FOLDER] [RENDER OPTION...] [DIFF OPTION...])
#
# a test that renders the scene (a file, or a built-in one by its name) and compares the frames with those
# in the folder EXPECTED (default: golden/NAME beside the CMakeLists.txt): of the clip, just the frames that
# the folder holds. RENDER and DIFF are options of `ropesim render` and `ropesim diff`. Where the test fails,
# golden/NAME/ in the build folder holds the frames and golden/NAME.html is the report.
get_filename_component(ropesim_prefix ${CMAKE_CURRENT_LIST_DIR}/../../.. ABSOLUTE)
if(NOT TARGET ropesim::ropesim)
    add_executable(ropesim::ropesim IMPORTED)
    set_target_properties(ropesim::ropesim PROPERTIES IMPORTED_LOCATION ${ropesim_prefix}/bin/ropesim)
endif()
set(ropesim_golden_test ${CMAKE_CURRENT_LIST_DIR}/ropesim-golden-test.cmake)

function(ropesim_add_golden_test name scene)
    cmake_parse_arguments(PARSE_ARGV 2 golden "" "EXPECTED" "RENDER;DIFF")
    if(golden_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "ropesim_add_golden_test(${name}): found '${golden_UNPARSED_ARGUMENTS}', "
            "expected EXPECTED, RENDER or DIFF")
    endif()
    set(expected golden/${name})
    if(golden_EXPECTED)
        set(expected ${golden_EXPECTED})
    endif()
    get_filename_component(expected ${expected} ABSOLUTE)
    get_filename_component(file ${scene} ABSOLUTE)
    if(EXISTS ${file})
        set(scene ${file})
    endif()
    add_test(NAME ${name} COMMAND ${CMAKE_COMMAND}
        -D program=$<TARGET_FILE:ropesim::ropesim> -D scene=${scene} -D expected=${expected}
        -D actual=${CMAKE_CURRENT_BINARY_DIR}/golden/${name} -D "render=${golden_RENDER}" -D "diff=${golden_DIFF}"
        -P ${ropesim_golden_test})
endfunction()
