#include "libdda/contact/cut_face.h"

#include "libdda/contact/face_points.h"
#include "libdda/contact/narrow_phase.h"
#include "libdda/model/state.h"

namespace voussoir::contact
{

namespace
{

// In the labels of all that the part which is apart has for itself.
constexpr std::uint32_t of_apart = 0x10000000;

constexpr double least_part = 1e-4;  // of the face: what is smaller is not cut off

void assign_tributary_areas(std::vector<PolygonPointIn<2>>& ends, const Eigen::Vector2d& /*normal*/)
{
    const double length = (ends[1].position - ends[0].position).norm();
    ends[0].area = ends[1].area = 0.5 * length;
}

template <int D>
double measure_of(const std::vector<PolygonPointIn<D>>& points)
{
    double sum = 0;
    for (const PolygonPointIn<D>& point : points) sum += point.area;
    return sum;
}

/// A face on both sides of the line where its gap is zero.
template <int D>
struct CutFace {
    std::vector<PolygonPointIn<D>> presses, apart;  // corners, in their order
    int crossings = 0;

    void cut(std::span<const double> gaps, const std::vector<PolygonPointIn<D>>& corners)
    {
        presses.clear();
        apart.clear();
        crossings = 0;
        const std::size_t n = corners.size(), sides = D == 3 ? n : n - 1;
        for (std::size_t i = 0; i < n; ++i) {
            const bool pressed = gaps[i] < 0;
            (pressed ? presses : apart).push_back(corners[i]);
            const std::size_t next = (i + 1) % n;
            if (i == sides || pressed == (gaps[next] < 0)) continue;
            ++crossings;
            add_end(corners[i], corners[next], gaps[i] / (gaps[i] - gaps[next]));
        }
    }
    /// @param part of the way from one corner to the next
    void add_end(const PolygonPointIn<D>& from, const PolygonPointIn<D>& to, double part)
    {
        PolygonPointIn<D> end{(1 - part) * from.position + part * to.position,
                              (1 - part) * from.gap + part * to.gap, 0, from.feature | on_cut_line};
        presses.push_back(end);
        end.feature |= of_apart;
        apart.push_back(end);
    }
    /// Whether the line parts the face in two.
    bool is_cut(const VectorIn<D>& normal, double whole)
    {
        if (crossings != (D == 3 ? 2 : 1)) return false;
        assign_tributary_areas(presses, normal);
        assign_tributary_areas(apart, normal);
        return measure_of<D>(presses) > least_part * whole && measure_of<D>(apart) > least_part * whole;
    }
};

}  // namespace

template <int D>
void add_points_of_parts(const VectorIn<D>& normal, std::span<const double> gaps,
                         std::vector<PolygonPointIn<D>>& points)
{
    thread_local CutFace<D> face;  // kept: this is done for each such face in each step
    face.cut(gaps, points);
    if (!face.is_cut(normal, measure_of<D>(points))) {
        add_inner_points(normal, points);
        return;
    }
    add_inner_points(normal, face.presses);
    add_inner_points(normal, face.apart);
    // The corners of the face as they follow one another, then all else.
    auto pressed = face.presses.begin(), open = face.apart.begin();
    for (std::size_t i = 0; i < gaps.size(); ++i) {
        auto& from = gaps[i] < 0 ? pressed : open;
        while ((from->feature & inner_feature) != 0) ++from;
        points[i] = *from++;
    }
    for (auto* part : {&face.presses, &face.apart})
        for (PolygonPointIn<D>& point : *part) {
            if ((point.feature & inner_feature) == 0 || point.area == 0) continue;
            if (part == &face.apart) point.feature |= of_apart;
            points.push_back(point);
        }
}

#define VOUSSOIR_INSTANTIATE(D) \
    template void add_points_of_parts(const VectorIn<D>&, std::span<const double>, std::vector<PolygonPointIn<D>>&)
VOUSSOIR_INSTANTIATE(3);
VOUSSOIR_INSTANTIATE(2);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::contact
