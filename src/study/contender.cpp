#include "study/contender.h"

namespace ropesim {
namespace {

class MethodSolver final : public Solver {
  public:
    MethodSolver(const Problem& problem, const Method& method, long steps_per_frame)
        : rope_(problem.rope), method_(method), stepping_(stepping(problem, steps_per_frame)) {
        restart();
    }
    void restart() override { state_ = at_rest(rope_); }
    bool advance() override {
        method_.advance(rope_, stepping_, state_, scratch_);
        return true;
    }
    Points position() const override { return state_.position; }
    Cost cost() const override { return scratch_.cost; }

  private:
    const Rope& rope_;
    const Method& method_;
    Stepping stepping_;
    State state_;
    Scratch scratch_;
};

}  // namespace

std::string label(const Contender& contender) {
    return contender.library.empty() ? contender.name : contender.library + ":" + contender.name;
}

Contender contender(const Method& method) {
    Contender contender;
    contender.name = method.name;
    contender.order = method.order;
    contender.method = &method;
    contender.make = [&method](const Problem& problem, double steps) -> std::unique_ptr<Solver> {
        return std::make_unique<MethodSolver>(problem, method, static_cast<long>(steps));
    };
    return contender;
}

double tolerance_scale(const Rope& rope) {
    return rope.rest_length * static_cast<double>(rope.mass.size() - 1);
}

}  // namespace ropesim
