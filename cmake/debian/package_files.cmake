# What a Debian package holds besides what is installed: the manual page, which is what --help says, the changelog,
# and the terms of ropesim and of what is compiled into it.
set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY})
set(documents ${root}/usr/share/doc/ropesim)
set(pages ${root}/usr/share/man/man1)

function(run)
    execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(MAKE_DIRECTORY ${documents} ${pages})
run(help2man --no-info --section 1 --name ${CPACK_PACKAGE_DESCRIPTION_SUMMARY}
    --output ${pages}/ropesim.1 ${root}/usr/bin/ropesim)
run(gzip -9nf ${pages}/ropesim.1)

configure_file(${CMAKE_CURRENT_LIST_DIR}/changelog ${documents}/changelog COPYONLY)
run(gzip -9nf ${documents}/changelog)

file(READ ${CMAKE_CURRENT_LIST_DIR}/../../LICENSE terms)
foreach(part fonts-dejavu-core libtomlplusplus-dev libcli11-dev nlohmann-json3-dev libxxhash-dev libeigen3-dev)
    file(READ /usr/share/doc/${part}/copyright more)
    string(APPEND terms "\n\nCompiled in, from Debian's ${part}:\n\n${more}")
endforeach()
file(WRITE ${documents}/copyright "${terms}")

# Whatever the umask of who makes the package.
run(chmod -R a=rX,u+w ${root}/usr)
