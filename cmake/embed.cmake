# embed_files(target function files...): compiles the files into the target. The generated header
# "<function>.h" declares, in namespace ropesim,
#     std::span<const std::pair<std::string_view, std::string_view>> <function>();
# the names (each file's path below BASE, default: the file's own name) and the bytes, in the given order.
function(embed_files target function)
    cmake_parse_arguments(PARSE_ARGV 2 embed "" "BASE" "FILES")
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/embedded_${function})
    # cet.h says what -fcf-protection says in compiled code: one object without it takes it from the program.
    set(assembly "#ifdef __CET__\n#include <cet.h>\n#endif\n    .section .rodata\n")
    set(declarations "")
    set(rows "")
    set(index 0)
    foreach(file IN LISTS embed_FILES)
        if(embed_BASE)
            file(RELATIVE_PATH name ${embed_BASE} ${file})
        else()
            get_filename_component(name ${file} NAME)
        endif()
        set(symbol ropesim_${function}_${index})
        string(APPEND assembly
            "    .global ${symbol}, ${symbol}_end\n${symbol}:\n    .incbin \"${file}\"\n${symbol}_end:\n    .byte 0\n")
        string(APPEND declarations "extern \"C\" const char ${symbol}[];\nextern \"C\" const char ${symbol}_end[];\n")
        string(APPEND rows
            "        {\"${name}\", {${symbol}, static_cast<std::size_t>(${symbol}_end - ${symbol})}},\n")
        math(EXPR index "${index} + 1")
    endforeach()
    string(APPEND assembly "    .section .note.GNU-stack,\"\",%progbits\n")
    set(signature "std::span<const std::pair<std::string_view, std::string_view>> ${function}()")
    file(CONFIGURE OUTPUT ${folder}/${function}.S CONTENT "${assembly}" @ONLY)
    file(CONFIGURE OUTPUT ${folder}/${function}.h @ONLY CONTENT
"#pragma once

#include <span>
#include <string_view>
#include <utility>

namespace ropesim {
// Files that were compiled in: name and bytes of each.
${signature};
}  // namespace ropesim
")
    file(CONFIGURE OUTPUT ${folder}/${function}.cpp @ONLY CONTENT
"#include \"${function}.h\"

#include <array>
#include <cstddef>

${declarations}
namespace ropesim {
${signature} {
    static const std::array<std::pair<std::string_view, std::string_view>, ${index}> files{{
${rows}    }};
    return files;
}
}  // namespace ropesim
")
    set_source_files_properties(${folder}/${function}.S PROPERTIES OBJECT_DEPENDS "${embed_FILES}")
    target_sources(${target} PRIVATE ${folder}/${function}.S ${folder}/${function}.cpp)
    target_include_directories(${target} PRIVATE ${folder})
endfunction()
