#include "libdda/analysis/vibration.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libdda/analysis/ground.h"
#include "libdda/block/block_step.h"
#include "libdda/contact/contact_history.h"
#include "libdda/contact/initial_contacts.h"
#include "libdda/contact/placed_part.h"
#include "libdda/contact/stone_bending.h"
#include "libdda/forces/other_forces.h"

namespace voussoir
{

namespace
{

/// The blocks as they are at the start of a step from rest that nothing drives. Boundaries carry them: dashpots
/// hold nothing, and a structure that floats has no modes to speak of.
/// @param others the springs of boundaries, of tied sides and of bars
template <class K>
std::vector<step::BlockStep<K>> blocks_at_rest(const Model& model, const State& state,
                                               step::OtherForces<K>& others)
{
    Stage stage;
    stage.type = StageType::static_equilibrium;
    stage.gravity.setZero();
    State rest = state;
    std::fill(rest.velocities.begin(), rest.velocities.end(), 0.0);
    begin_stage(model, 0, rest);
    std::vector<step::BlockStep<K>> blocks(model.blocks.size());
    for (int b = 0; b < static_cast<int>(blocks.size()); ++b) {
        step::begin_block(model, stage, rest, b, 1.0, 1.0, blocks[b]);
        blocks[b].row = -1;
    }
    others.each([&](auto& group) { step::begin_forces(model, stage, rest, 1.0, 1.0, blocks, group); });
    return blocks;
}

/// Forces get the stiffness that they have at rest: a slack bar has none.
template <class K>
void find_stiffness_at_rest(int rows, const std::vector<step::BlockStep<K>>& blocks, step::OtherForces<K>& others)
{
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(rows * K::unknowns);
    std::vector<double> load(rows, 0.0);
    const Eigen::VectorXd unmoved = forces;
    others.each([&](auto& group) { step::add_forces(unmoved, blocks, group, forces, load); });
}

template <class K>
bool all_held(const step::BlockStep<K>& block)
{
    return std::all_of(block.held.begin(), block.held.end(), [](bool held) { return held; });
}

/// Extent of a block along a direction [m].
template <int D>
double depth_along(const Block& block, const MatrixIn<D>& map, const VectorIn<D>& direction)
{
    const VectorIn<D> turned = map.transpose() * direction;
    double low = INFINITY, high = -INFINITY;
    for (const auto& part : contact::ShapeIn<D>::of(block))
        for (const VectorIn<D>& x : part.vertices) {
            low = std::min(low, turned.dot(x));
            high = std::max(high, turned.dot(x));
        }
    return high - low;
}

/// The points of closed joints, in the order of the contacts.
template <class K>
class ClosedJoints
{
    static constexpr int D = K::dimension;

 public:
    ClosedJoints(const Model& model, const State& state, std::vector<step::BlockStep<K>>& blocks)
        : model_(model), blocks_(blocks), has_stepped_(state.step > 0)
    {
        const ContactSetIn<D>& contacts = contacts_in<D>(state);
        for (const ContactPatchIn<D>& patch : contacts.patches) {
            for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i)
                if (is_closed(patch, contacts.points[i])) add(patch, contacts.points[i]);
            if constexpr (K::deformable) bend(contacts, patch);
            ++patch_;
        }
    }

    std::vector<VibratingPoint<K>> points;
    std::vector<BentFace<K>> bent;
    std::vector<std::pair<int, int>> blocks_of_points;

 private:
    bool is_closed(const ContactPatchIn<D>& patch, const ContactPointIn<D>& point) const
    {
        if (patch.intact) return true;
        if (has_stepped_) return point.normal_force > 0;
        const double size = std::min(blocks_[patch.block_a].size, blocks_[patch.block_b].size);
        return point.gap <= contact::closed_at_start * size;
    }

    void add(const ContactPatchIn<D>& patch, const ContactPointIn<D>& found)
    {
        const JointMaterial& joint = model_.joint_between(patch.block_a, patch.block_b);
        VibratingPoint<K> point;
        point.patch = patch_;
        point.lever_a = found.position - blocks_[patch.block_a].start.centroid;
        point.lever_b = found.position - blocks_[patch.block_b].start.centroid;
        point.normal = patch.normal;
        point.normal_stiffness = patch.stiffness * found.area;
        point.shear_stiffness = joint.shear_to_normal_stiffness * point.normal_stiffness;
        point.relaxation_time = joint.relaxation_time;
        point.measured = joint.stiffness.kind == ContactStiffness::Kind::per_area;
        point.at_corners = joint.face == FaceLaw::corners;
        for (const int b : {patch.block_a, patch.block_b}) add_half_stone(b, patch, joint, point);
        points.push_back(point);
        blocks_of_points.emplace_back(patch.block_a, patch.block_b);
    }

    /// @param patch of which the closed points are the last ones
    void bend(const ContactSetIn<D>& contacts, const ContactPatchIn<D>& patch)
    {
        if (patch.edge_edge || points.empty() || points.back().patch != patch_) return;
        const step::BlockStep<K>&a = blocks_[patch.block_a], &b = blocks_[patch.block_b];
        BentFace<K> face;
        face.end = static_cast<int>(points.size());
        for (face.first = face.end; face.first > 0 && points[face.first - 1].patch == patch_;) --face.first;
        double area = 0;
        typename K::Vector centre = K::Vector::Zero();
        for (const ContactPointIn<D>& point : points_of(contacts, patch)) {
            area += point.area;
            centre += point.area * point.position;
        }
        centre /= area;
        face.centre = centre - a.start.centroid;
        const contact::HalfStone<D> of_a{patch.block_a, a.start.map, all_held(a)},
            of_b{patch.block_b, b.start.map, all_held(b)};
        const typename K::Matrix bends = contact::bending_flexibility(model_, of_a, of_b, patch.normal, area);
        if (bends.isZero(0)) return;
        const double twists = contact::twist_flexibility(model_, of_a, of_b, patch.normal, area);
        contact::MomentOf<D> tilted;
        double turned = 0;
        for (int i = face.first; i < face.end; ++i) {
            tilted.add(0, points[i].normal_stiffness, face.place(points[i]));
            turned += points[i].shear_stiffness * face.around(points[i]).squaredNorm();
        }
        face.give.template topLeftCorner<D, D>() = contact::give_of(bends, 1, tilted.second);
        face.give(D, D) = twists / (1 + turned * twists);
        bent.push_back(face);
    }

    /// Ground is a continuum, cut into blocks: it strains with its neighbours and does not bend between its
    /// joints.
    void add_half_stone(int block, const ContactPatchIn<D>& patch, const JointMaterial& joint,
                        VibratingPoint<K>& point) const
    {
        if (all_held(blocks_[block]) || ground_[block]) return;
        const BlockMaterial& material = model_.materials[model_.blocks[block].material];
        const double half = 0.5 * depth_along<D>(model_.blocks[block], blocks_[block].start.map, patch.normal);
        point.stone_normal += patch.stiffness * half / material.young;
        point.stone_shear +=
            joint.shear_to_normal_stiffness * patch.stiffness * half * 2 * (1 + material.poisson) / material.young;
    }

    const Model& model_;
    const std::vector<step::BlockStep<K>>& blocks_;
    std::vector<bool> ground_ = ground_marks(model_);
    bool has_stepped_ = false;
    int patch_ = 0;
};

/// Gives rows to the blocks that move and that a closed joint or a bar holds, and puts them into the points.
/// @returns the block of each row
template <class K>
std::vector<int> number_rows(const std::vector<Bar>& bars, ClosedJoints<K>& joints,
                             std::vector<step::BlockStep<K>>& blocks)
{
    std::vector<bool> touched(blocks.size(), false);
    for (const Bar& bar : bars) touched[bar.block_a] = touched[bar.block_b] = true;
    for (const auto& [a, b] : joints.blocks_of_points) touched[a] = touched[b] = true;
    std::vector<int> block_of_row;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        if (!touched[b] || all_held(blocks[b])) continue;
        blocks[b].row = static_cast<int>(block_of_row.size());
        block_of_row.push_back(static_cast<int>(b));
    }
    for (std::size_t i = 0; i < joints.points.size(); ++i) {
        joints.points[i].row_a = blocks[joints.blocks_of_points[i].first].row;
        joints.points[i].row_b = blocks[joints.blocks_of_points[i].second].row;
    }
    return block_of_row;
}

template <class K>
using BlockView = Eigen::Map<typename K::Square>;

template <class K>
void set_pattern(int rows, const step::OtherForces<K>& others, const std::vector<step::BlockStep<K>>& blocks,
                 Vibration<K>& vibration)
{
    std::vector<std::pair<int, int>> pairs;
    for (const VibratingPoint<K>& p : vibration.points)
        if (p.row_a >= 0 && p.row_b >= 0)
            pairs.emplace_back(std::max(p.row_a, p.row_b), std::min(p.row_a, p.row_b));
    others.each([&](const auto& group) { step::add_pairs(blocks, group, pairs); });
    solve::set_pattern(vibration.stiffness, K::unknowns, rows, pairs);
}

template <class K>
void add_block(const step::BlockStep<K>& block, Vibration<K>& vibration)
{
    constexpr int n = K::unknowns, D = K::dimension;
    using Square = typename K::Square;
    BlockView<K>(vibration.stiffness.block(vibration.stiffness.diagonal(block.row))) += block.base - block.inertia;
    Square mass = K::mass_matrix(block.mass, block.spread);
    for (int k = 0; k < n; ++k)
        if (block.held[k]) {
            mass.row(k).setZero();
            mass.col(k).setZero();
        }
    BlockView<K>(vibration.mass.data() + block.row * n * n) = mass;
    for (int k = 0; k < D; ++k) vibration.translating_mass[block.row * D + k] = block.held[k] ? 0 : block.mass;
}

template <class K>
void add_joint(const VibratingPoint<K>& p, solve::BlockMatrix& stiffness)
{
    using Matrix = typename K::Matrix;
    const Matrix across = p.normal * p.normal.transpose(), along = Matrix::Identity() - across;
    const Matrix c = p.normal_stiffness * across + p.shear_stiffness * along;
    const auto add = [&](int row, int column, const auto& y_row, const auto& y_column, const Matrix& with) {
        const int at = row == column ? stiffness.diagonal(row) : stiffness.position(row, column);
        typename K::Square block = K::Square::Zero();
        K::add_stiffness(block, y_row, y_column, with);
        BlockView<K>(stiffness.block(at)) += block;
    };
    if (p.row_a >= 0) add(p.row_a, p.row_a, p.lever_a, p.lever_a, c);
    if (p.row_b >= 0) add(p.row_b, p.row_b, p.lever_b, p.lever_b, c);
    if (p.row_a < 0 || p.row_b < 0) return;
    if (p.row_a > p.row_b)
        add(p.row_a, p.row_b, p.lever_a, p.lever_b, Matrix(-c));
    else
        add(p.row_b, p.row_a, p.lever_b, p.lever_a, Matrix(-c));
}

/// Takes off what the stones beside a face give as they bend.
template <class K>
void add_bending(const BentFace<K>& face, const std::vector<VibratingPoint<K>>& points,
                 solve::BlockMatrix& stiffness)
{
    using Moments = Eigen::Matrix<double, K::unknowns, BentFace<K>::turns>;  // by the unknowns of a block
    constexpr int D = K::dimension;
    Moments of_a = Moments::Zero(), of_b = Moments::Zero();
    const auto add = [](const typename K::Vector& lever, const typename K::Vector& direction) {
        typename K::Unknowns moved = K::Unknowns::Zero();
        K::add_force(moved, lever, direction);
        return moved;
    };
    for (int i = face.first; i < face.end; ++i) {
        const VibratingPoint<K>& p = points[i];
        const typename K::Vector place = p.normal_stiffness * face.place(p),
                                 around = p.shear_stiffness * face.around(p);
        of_a.template leftCols<D>() += add(p.lever_a, p.normal) * place.transpose();
        of_b.template leftCols<D>() -= add(p.lever_b, p.normal) * place.transpose();
        of_a.col(D) += add(p.lever_a, around);
        of_b.col(D) -= add(p.lever_b, around);
    }
    const auto take = [&](int row, int column, const Moments& of_row, const Moments& of_column) {
        const int at = row == column ? stiffness.diagonal(row) : stiffness.position(row, column);
        BlockView<K>(stiffness.block(at)) -= of_row * face.give * of_column.transpose();
    };
    const int a = points[face.first].row_a, b = points[face.first].row_b;
    if (a >= 0) take(a, a, of_a, of_a);
    if (b >= 0) take(b, b, of_b, of_b);
    if (a < 0 || b < 0) return;
    if (a > b)
        take(a, b, of_a, of_b);
    else
        take(b, a, of_b, of_a);
}

/// Held components: their rows and columns become those of the identity.
template <class K>
void hold(const std::vector<step::BlockStep<K>>& blocks, solve::BlockMatrix& stiffness)
{
    std::vector<const step::BlockStep<K>*> of_row(stiffness.rows());
    for (const step::BlockStep<K>& block : blocks)
        if (block.row >= 0) of_row[block.row] = &block;
    for (int row = 0; row < stiffness.rows(); ++row)
        for (int p = stiffness.row_start[row]; p < stiffness.row_start[row + 1]; ++p) {
            const int column = stiffness.columns[p];
            BlockView<K> block(stiffness.block(p));
            for (int k = 0; k < K::unknowns; ++k) {
                if (of_row[row]->held[k]) block.row(k).setZero();
                if (of_row[column]->held[k]) block.col(k).setZero();
                if (row == column && of_row[row]->held[k]) block(k, k) = 1;
            }
        }
}

}  // namespace

template <class K>
Vibration<K> vibration_about(const Model& model, const State& state)
{
    constexpr int n = K::unknowns;
    State with_contacts = state;
    if (state.step == 0) find_initial_contacts(model, with_contacts);
    step::OtherForces<K> others;
    std::vector<step::BlockStep<K>> blocks = blocks_at_rest<K>(model, with_contacts, others);
    ClosedJoints<K> joints(model, with_contacts, blocks);
    Vibration<K> vibration;
    vibration.block_of_row = number_rows(model.bars, joints, blocks);
    const int rows = static_cast<int>(vibration.block_of_row.size());
    find_stiffness_at_rest(rows, blocks, others);
    vibration.points = std::move(joints.points);
    vibration.bent = std::move(joints.bent);
    vibration.mass.assign(static_cast<std::size_t>(rows) * n * n, 0.0);
    vibration.translating_mass.assign(static_cast<std::size_t>(rows) * K::dimension, 0.0);
    set_pattern(rows, others, blocks, vibration);
    for (const step::BlockStep<K>& block : blocks)
        if (block.row >= 0) add_block(block, vibration);
    for (const VibratingPoint<K>& point : vibration.points) add_joint(point, vibration.stiffness);
    for (const BentFace<K>& face : vibration.bent) add_bending(face, vibration.points, vibration.stiffness);
    others.each([&](const auto& group) { step::add_stiffness(blocks, group, vibration.stiffness); });
    hold(blocks, vibration.stiffness);
    return vibration;
}

#define VOUSSOIR_INSTANTIATE(K) template Vibration<step::K> vibration_about(const Model&, const State&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir
