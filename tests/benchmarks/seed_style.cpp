#include "benchmarks/seed_style.h"

#include <cmath>

namespace ropesim {

SeedStyle::SeedStyle(int masses) {
    const double rest_length = 400.0 / (masses - 1);
    for (int i = 0; i < masses; ++i)
        masses_.push_back(std::make_unique<Mass>(Mass{1.0, i == 0, {-i * rest_length, 200.0}, {}, {}}));
    for (int i = 0; i + 1 < masses; ++i) {
        const auto at = static_cast<std::size_t>(i);
        springs_.push_back(
            std::make_unique<Spring>(Spring{100.0, rest_length, masses_[at].get(), masses_[at + 1].get()}));
    }
}

void SeedStyle::advance(long steps) {
    const double dt = 1.0 / 64;
    const Vector gravity{0.0, -1.0};
    for (long step = 0; step < steps; ++step) {
        for (const auto& spring : springs_) {
            Mass& a = *spring->first;
            Mass& b = *spring->second;
            const Vector d{b.position.x - a.position.x, b.position.y - a.position.y};
            const double length = std::sqrt(d.x * d.x + d.y * d.y);
            const double pull = spring->stiffness * (length - spring->rest_length) / length;
            a.force.x += pull * d.x;
            a.force.y += pull * d.y;
            b.force.x -= pull * d.x;
            b.force.y -= pull * d.y;
        }
        for (const auto& mass : masses_) {
            if (!mass->pinned) {
                mass->force.x += mass->mass * gravity.x;
                mass->force.y += mass->mass * gravity.y;
                mass->velocity.x += mass->force.x / mass->mass * dt;
                mass->velocity.y += mass->force.y / mass->mass * dt;
                mass->position.x += mass->velocity.x * dt;
                mass->position.y += mass->velocity.y * dt;
            }
            mass->force = {};
        }
    }
}

}  // namespace ropesim
