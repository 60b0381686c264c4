// Prints how a rope moves by the method named on the command line: the program that SameBits compares with.
#include "simulation/motion.h"

#include <cstdio>

int main(int, char** arguments) {
    std::fputs(ropesim::motion(ropesim::find_method(arguments[1])).c_str(), stdout);
}
