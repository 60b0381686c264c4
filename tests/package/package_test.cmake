# Installs the program that is in `build` and uses it from another project, a copy of the one in this folder:
# its golden test passes, and fails, with a report, where a frame is another.
cmake_minimum_required(VERSION 3.16)

function(run)
    execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
    set(status ${status} PARENT_SCOPE)
    set(output "${output}" PARENT_SCOPE)
endfunction()

function(must_pass)
    run(${ARGV})
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "${ARGV}: failed\n${output}")
    endif()
endfunction()

file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
must_pass(${CMAKE_COMMAND} --install ${build} --prefix ${folder}/installed)
file(COPY ${CMAKE_CURRENT_LIST_DIR}/CMakeLists.txt ${CMAKE_CURRENT_LIST_DIR}/swing.toml
    ${CMAKE_CURRENT_LIST_DIR}/golden DESTINATION ${folder}/swing)
must_pass(${CMAKE_COMMAND} -G ${generator} -S ${folder}/swing -B ${folder}/build -D CMAKE_PREFIX_PATH=${folder}/installed)
must_pass(ctest --test-dir ${folder}/build --output-on-failure)

file(RENAME ${folder}/swing/golden/swing/frame_0020.png ${folder}/swing/golden/swing/frame_0021.png)
run(ctest --test-dir ${folder}/build --output-on-failure)
if(status EQUAL 0)
    message(FATAL_ERROR "the golden test passed, with a frame that is another")
endif()
if(NOT output MATCHES "frame_0021.png: differs" OR NOT EXISTS ${folder}/build/golden/swing.html)
    message(FATAL_ERROR "the golden test failed and did not say why:\n${output}")
endif()

file(REMOVE_RECURSE ${folder}/swing/golden)
run(ctest --test-dir ${folder}/build --output-on-failure)
if(NOT output MATCHES "no frames in [^\n]*golden/swing\n")
    message(FATAL_ERROR "the golden test without frames did not say so:\n${output}")
endif()
