#include "fuzz/target.h"

#include "scene/words.h"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace ropesim {

void break_off(std::string_view what) {
    std::fprintf(stderr, "broken promise: %s\n", std::string(what).c_str());
    std::abort();
}

void require_plain(std::string_view message) {
    if (message.empty() || !is_plain(message))
        break_off("the message '" + std::string(message) + "' is not one line of plain text");
}

}  // namespace ropesim
