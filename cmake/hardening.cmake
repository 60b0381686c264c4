# What turns a wrong write into a stop instead of a way in; the test package.ProgramIsHardened asks for it.
include(CheckCXXCompilerFlag)

# Our libraries end in programs, so -fPIE does for them: -fPIC would keep functions from being inlined.
target_compile_options(ropesim_options INTERFACE -fPIE -fstack-protector-strong)
target_link_options(ropesim_options INTERFACE -pie -Wl,-z,relro,-z,now)
# Where the compiler has them for this processor.
foreach(flag -fstack-clash-protection -fcf-protection)
    string(MAKE_C_IDENTIFIER has${flag} has)
    check_cxx_compiler_flag(${flag} ${has})
    if(${has})
        target_compile_options(ropesim_options INTERFACE ${flag})
    endif()
endforeach()
# Checked copies in libc need an optimising compiler, and the address sanitizer checks the same and more.
if(NOT ROPESIM_SANITIZE)
    target_compile_options(ropesim_options INTERFACE $<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3>)
endif()
