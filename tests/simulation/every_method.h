#pragma once

#include "simulation/chains.h"

#include <gtest/gtest.h>

#include <string>

namespace ropesim {

// The rows of the table, as the parameters of a suite, and how a test is named for its row:
//   INSTANTIATE_TEST_SUITE_P(Table, Suite, every_method(), row_name);
inline auto every_method() {
    return testing::ValuesIn(methods().begin(), methods().end());
}

inline std::string row_name(const testing::TestParamInfo<Method>& row) {
    return std::string(row.param.name);
}

}  // namespace ropesim
