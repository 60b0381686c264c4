# What a golden test of ropesim_add_golden_test does.
cmake_minimum_required(VERSION 3.16)

file(GLOB frames RELATIVE ${expected} ${expected}/frame_*.png)
if(NOT frames)
    message("no frames in ${expected}\nto make them: ${program} render ${scene} --frames 0,60,119 -o ${expected}")
    message(FATAL_ERROR "nothing to compare with")
endif()
list(TRANSFORM frames REPLACE "^frame_([0-9]+)\\.png$" "\\1")
list(JOIN frames "," list)

get_filename_component(folder ${actual} DIRECTORY)
file(REMOVE_RECURSE ${actual} ${actual}.html)
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${program} render ${scene} --frames ${list} -o ${actual} --quiet ${render}
    RESULT_VARIABLE status)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "${scene}: was not rendered")
endif()
execute_process(COMMAND ${program} diff ${expected} ${actual} --report ${actual}.html ${diff}
    RESULT_VARIABLE status)
if(NOT status EQUAL 0)
    message("report: ${actual}.html\nto accept the frames, once looked at: ${program} diff ${expected} ${actual} --accept")
    message(FATAL_ERROR "the frames differ")
endif()
