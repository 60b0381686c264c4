#include "benchmarks/frame_makers.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <memory>

namespace ropesim {

MakeFrame by_opencv(const Scene& scene) {
    const auto picture = std::make_shared<cv::Mat>(scene.size[1], scene.size[0], CV_8UC3);
    const double scale = scene.size[1] / scene.view.height;
    return [=, &scene](long, const std::vector<Points>& positions, const std::filesystem::path& path) {
        constexpr int shift = 4;  // coordinates in 16ths of a pixel
        const auto color = [](const Color& rgb) { return cv::Scalar(rgb[2], rgb[1], rgb[0]); };
        const auto place = [&](const Points& points, Eigen::Index mass) {
            const double column = scene.size[0] / 2.0 + (points(mass, 0) - scene.view.center.x()) * scale;
            const double row = scene.size[1] / 2.0 - (points(mass, 1) - scene.view.center.y()) * scale;
            return cv::Point(cvRound(column * (1 << shift)), cvRound(row * (1 << shift)));
        };
        picture->setTo(color(scene.background));
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const SceneRope& rope = scene.ropes[i];
            for (Eigen::Index mass = 0; mass < positions[i].rows(); ++mass) {
                const cv::Point at = place(positions[i], mass);
                if (mass + 1 < positions[i].rows())
                    cv::line(*picture, at, place(positions[i], mass + 1), color(rope.color),
                             cvRound(rope.line_width), cv::LINE_AA, shift);
                cv::circle(*picture, at, cvRound(rope.point_size / 2 * (1 << shift)), color(rope.color),
                           cv::FILLED, cv::LINE_AA, shift);
            }
        }
        if (scene.words)
            cv::putText(*picture, scene.title, {10, 24}, cv::FONT_HERSHEY_SIMPLEX, 0.6, {255, 255, 255}, 1,
                        cv::LINE_AA);
        cv::imwrite(path.string(), *picture);
    };
}

}  // namespace ropesim
