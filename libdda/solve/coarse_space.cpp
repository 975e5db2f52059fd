#include "libdda/solve/coarse_space.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "libdda/model/parallel.h"
#include "libdda/solve/aggregates.h"
#include "libdda/solve/block_kernels.h"
#include "libdda/solve/cluster_shapes.h"
#include "libdda/solve/single_factor.h"

namespace voussoir::solve
{

using Eigen::VectorXd;

namespace
{

constexpr int least_rows = 256;         // below, the factor of near neighbours is as good
constexpr double least_contacts = 1.2;  // per row: a chain is factorised exactly
constexpr int rows_in_aggregate = 24;
constexpr int rows_in_aggregate_of_many = 12;  // whose coarse factor is cheaper, for it is in single precision
constexpr int most_aggregates = 1024;

bool are_many(int rows)
{
    return rows >= blocks_worth_threads;
}

/// How many rows an aggregate has, some.
int rows_in(int rows)
{
    return are_many(rows) ? std::max(rows_in_aggregate_of_many, rows / most_aggregates) : rows_in_aggregate;
}

}  // namespace

class CoarseSpace::Implementation
{
 public:
    virtual ~Implementation() = default;
    virtual bool prepare(const BlockMatrix& matrix, const ColumnsOf& columns, int threads) = 0;
    virtual void factorise() = 0;
    virtual void start(const VectorXd& b, int threads, VectorXd& x) = 0;
    virtual void correct(const VectorXd& r, int threads, VectorXd& z) = 0;

    RowPlaces places;
};

namespace
{

template <class Shape>
class CoarseSpaceOf : public CoarseSpace::Implementation
{
    static constexpr int n = Shape::unknowns, D = Shape::dimension;
    using K = Kernels<n>;
    using Square = typename K::Square;
    using Segment = typename K::Segment;
    using Block = typename K::Block;
    using ConstBlock = typename K::ConstBlock;
    using Lever = typename Shape::Lever;
    using Single = SinglePrecision<n>;

 public:
    bool prepare(const BlockMatrix& matrix, const ColumnsOf& columns, int threads) override
    {
        const int rows = matrix.rows();
        if (rows < least_rows || static_cast<int>(places.free.size()) != rows || matrix.block_size != n)
            return false;
        if (static_cast<double>(matrix.columns.size()) < (1 + least_contacts) * rows) return false;
        if (columns_ != matrix.columns || row_start_ != matrix.row_start || free_ != places.free) analyse(matrix);
        if (aggregates_.count < 2) return false;
        in_parallel(levers_.size(), threads, [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i)
                levers_[i] = Eigen::Map<const Lever>(places.centres.data() + D * i);
        });
        each_aggregate(threads, [&](int a) { set_levers(a); });
        product_.values.resize(product_.columns.size() * n * n);
        in_parallel(levers_.size(), threads, [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i) multiply(matrix, columns, static_cast<int>(i));
        });
        coarse_.values.resize(coarse_.columns.size() * n * n);
        each_aggregate(threads, [&](int a) { project(a); });
        if (is_large_) round_product(threads);
        return true;
    }

    void factorise() override
    {
        is_single_ = is_large_ && factorise_in_single();
        if (!is_single_) K::factorise(coarse_, factor_);
    }

    void start(const VectorXd& b, int threads, VectorXd& x) override
    {
        load_.resize(n * aggregates_.count);
        each_aggregate(threads, [&](int a) { gather(b, a); });
        x.setZero(b.size());
        spread(threads, x);
    }

    void correct(const VectorXd& r, int threads, VectorXd& z) override
    {
        load_.resize(n * aggregates_.count);
        if (is_single_) {
            each_aggregate(threads, [&](int a) {
                gather(r, a);
                gather_in_single(z, a);
            });
            spread(threads, z);
            return;
        }
        each_aggregate(threads, [&](int a) {
            gather(r, a);
            Segment load = load_.segment<n>(n * a);
            for (int k = met_by_.start[a]; k < met_by_.start[a + 1]; ++k)
                load -= K::block(product_, met_by_.positions[k])
                            .transpose()
                            .lazyProduct(z.segment<n>(n * met_by_.rows[k]));
            load_.segment<n>(n * a) = load;
        });
        spread(threads, z);
    }

 private:
    template <class Work>
    void each_aggregate(int threads, const Work& work)
    {
        each_in_parallel(members_.size(), threads, [&](std::size_t a) { work(static_cast<int>(a)); });
    }

    /// Aggregates, the pattern of K P and the envelope of P^T K P: what the pattern of the matrix decides.
    void analyse(const BlockMatrix& matrix)
    {
        columns_ = matrix.columns;
        row_start_ = matrix.row_start;
        free_ = places.free;
        const int rows = matrix.rows();
        is_large_ = are_many(rows);
        aggregates_ = aggregate(matrix, free_, rows_in(rows));
        members_.assign(aggregates_.count, {});
        for (int i = 0; i < rows; ++i)
            if (aggregates_.of_row[i] >= 0) members_[aggregates_.of_row[i]].push_back(i);
        levers_.resize(rows);
        set_product_pattern(matrix);
        set_envelope();
    }

    void set_product_pattern(const BlockMatrix& matrix)
    {
        const std::vector<int>& of = aggregates_.of_row;
        const int rows = matrix.rows();
        std::vector<std::vector<int>> met(rows);  // aggregates that a row meets
        const auto meets = [&](int row, int other) {
            if (of[other] < 0) return;
            std::vector<int>& known = met[row];
            if (std::find(known.begin(), known.end(), of[other]) == known.end()) known.push_back(of[other]);
        };
        for (int i = 0; i < rows; ++i)
            for (int p = matrix.row_start[i]; p < matrix.row_start[i + 1]; ++p) {
                meets(i, matrix.columns[p]);
                meets(matrix.columns[p], i);
            }
        product_.block_size = n;
        product_.row_start.assign(1, 0);
        product_.columns.clear();
        for (std::vector<int>& known : met) {
            std::sort(known.begin(), known.end());
            product_.columns.insert(product_.columns.end(), known.begin(), known.end());
            product_.row_start.push_back(static_cast<int>(product_.columns.size()));
        }
        set_met_by();
        of_row_.clear();
        of_column_.clear();
        for (int i = 0; i < rows; ++i)
            for (int p = matrix.row_start[i]; p < matrix.row_start[i + 1]; ++p) {
                const int j = matrix.columns[p];
                of_row_.push_back(of[j] < 0 ? -1 : product_.position(i, of[j]));
                of_column_.push_back(of[i] < 0 ? -1 : product_.position(j, of[i]));
            }
    }

    /// The product's blocks by aggregates, rows ascending.
    void set_met_by()
    {
        met_by_.start.assign(aggregates_.count + 1, 0);
        for (const int a : product_.columns) ++met_by_.start[a + 1];
        for (int a = 0; a < aggregates_.count; ++a) met_by_.start[a + 1] += met_by_.start[a];
        met_by_.rows.resize(product_.columns.size());
        met_by_.positions.resize(product_.columns.size());
        std::vector<int> place(met_by_.start.begin(), met_by_.start.end() - 1);
        for (int i = 0; i + 1 < static_cast<int>(product_.row_start.size()); ++i)
            for (int p = product_.row_start[i]; p < product_.row_start[i + 1]; ++p) {
                int& at = place[product_.columns[p]];
                met_by_.rows[at] = i;
                met_by_.positions[at++] = p;
            }
    }

    /// All columns from the first of each row to the diagonal: a Cholesky factor fills no others.
    void set_envelope()
    {
        std::vector<int> first(aggregates_.count);
        for (int a = 0; a < aggregates_.count; ++a) first[a] = a;
        for (std::size_t i = 0; i < aggregates_.of_row.size(); ++i) {
            const int a = aggregates_.of_row[i];
            if (a < 0) continue;
            for (int p = product_.row_start[i]; p < product_.row_start[i + 1]; ++p)
                first[a] = std::min(first[a], product_.columns[p]);
        }
        coarse_.block_size = n;
        coarse_.row_start.assign(1, 0);
        coarse_.columns.clear();
        for (int a = 0; a < aggregates_.count; ++a) {
            for (int k = first[a]; k <= a; ++k) coarse_.columns.push_back(k);
            coarse_.row_start.push_back(static_cast<int>(coarse_.columns.size()));
        }
        factor_ = coarse_;
        if (is_large_) below_ = columns_of(coarse_);
    }

    /// Levers from the mean of the centres of an aggregate.
    void set_levers(int a)
    {
        Lever centre = Lever::Zero();
        for (const int i : members_[a]) centre += levers_[i];
        for (const int i : members_[a]) levers_[i] -= centre / static_cast<double>(members_[a].size());
    }

    /// Row i of product = K P
    void multiply(const BlockMatrix& matrix, const ColumnsOf& columns, int i)
    {
        std::fill(product_.block(product_.row_start[i]), product_.block(product_.row_start[i + 1]), 0.0);
        const auto add = [&](int position, int other, Square block) {
            if (position < 0) return;
            Shape::right(levers_[other], block);
            Block(product_.block(position)) += block;
        };
        for (int p = matrix.row_start[i]; p < matrix.row_start[i + 1]; ++p)
            add(of_row_[p], matrix.columns[p], K::block(matrix, p));
        for (int k = columns.start[i]; k < columns.start[i + 1]; ++k) {
            const int p = columns.positions[k];
            add(of_column_[p], columns.rows[k], K::block(matrix, p).transpose());
        }
    }

    /// Row a of coarse = P^T K P
    void project(int a)
    {
        const int start = coarse_.row_start[a], first = coarse_.columns[start];
        std::fill(coarse_.block(start), coarse_.block(coarse_.row_start[a + 1]), 0.0);
        for (const int i : members_[a])
            for (int p = product_.row_start[i]; p < product_.row_start[i + 1] && product_.columns[p] <= a; ++p) {
                Square left = K::block(product_, p);
                Shape::left(levers_[i], left);
                Block(coarse_.block(start + product_.columns[p] - first)) += left;
            }
    }

    /// Row a of load = P^T r
    void gather(const VectorXd& r, int a)
    {
        Segment load = Segment::Zero();
        for (const int i : members_[a]) {
            Segment of_row = r.segment<n>(n * i);
            if (is_large_)
                Shape::left_quickly(levers_[i], of_row);
            else
                Shape::left(levers_[i], of_row);
            load += of_row;
        }
        load_.segment<n>(n * a) = load;
    }

    /// (K P)^T in single precision, by aggregates.
    void round_product(int threads)
    {
        Single::resize(product_.columns.size(), turned_);
        in_parallel(product_.columns.size(), threads, [&](std::size_t first, std::size_t end) {
            for (std::size_t k = first; k < end; ++k)
                Single::put(K::block(product_, met_by_.positions[k]).transpose(), k, turned_);
        });
    }

    bool factorise_in_single()
    {
        const Eigen::Index size = static_cast<Eigen::Index>(single_.width) * aggregates_.count;
        if (moved_in_single_.size() != size) moved_in_single_.setZero(size);
        single_.resize(coarse_);
        for (int a = 0; a < aggregates_.count; ++a)
            if (single_.factorise_row(coarse_, a, [&](int p, auto& columns) {
                    Single::take(K::block(coarse_, p), columns);
                }) < least_left)
                return false;
        return true;
    }

    /// load -= (K P)^T z
    void gather_in_single(const VectorXd& z, int a)
    {
        typename Single::Sum sum = Single::Sum::Zero();
        for (int k = met_by_.start[a]; k < met_by_.start[a + 1]; ++k)
            sum += Single::product(turned_, k, z.data() + n * met_by_.rows[k]);
        load_.segment<n>(n * a) -= sum.template head<n>().matrix().template cast<double>();
    }

    /// moved = (P^T K P)^-1 load
    void solve_in_single()
    {
        float* const x = moved_in_single_.data();
        for (int a = 0; a < aggregates_.count; ++a) single_.forward(coarse_, a, load_.segment<n>(n * a), x);
        moved_.resize(load_.size());
        for (int a = aggregates_.count - 1; a >= 0; --a) {
            single_.backward(coarse_, below_, a, x);
            moved_.segment<n>(n * a) = moved_in_single_.segment<n>(single_.width * a).template cast<double>();
        }
    }

    /// z += P (P^T K P)^-1 load
    void spread(int threads, VectorXd& z)
    {
        if (is_single_)
            solve_in_single();
        else
            K::precondition(factor_, load_, moved_);
        each_aggregate(threads, [&](int a) {
            const Segment of_all = moved_.segment<n>(n * a);
            for (const int i : members_[a]) {
                Segment of_row = of_all;
                if (is_large_)
                    Shape::spread_quickly(levers_[i], of_row);
                else
                    Shape::spread(levers_[i], of_row);
                z.segment<n>(n * i) += of_row;
            }
        });
    }

    std::vector<int> columns_, row_start_;  // of the matrix that was analysed
    std::vector<char> free_;
    Aggregates aggregates_;
    std::vector<std::vector<int>> members_;  // rows of the aggregates, ascending
    std::vector<Lever> levers_;              // m, (rows)
    BlockMatrix product_;                    // K P: rows x aggregates, not only a lower triangle
    ColumnsOf met_by_;                       // the same by aggregates
    std::vector<int> of_row_, of_column_;    // of each block of the matrix: its positions in the product
    BlockMatrix coarse_, factor_;
    VectorXd load_, moved_;  // (aggregates x unknowns)

    bool is_large_ = false, is_single_ = false;
    std::vector<float> turned_;  // (K P)^T by aggregates
    SingleFactor<n> single_;
    ColumnsOf below_;                  // the columns of `coarse_`
    Eigen::VectorXf moved_in_single_;  // a segment as wide as SinglePrecision has, zeros behind its numbers
};

std::unique_ptr<CoarseSpace::Implementation> make(Kinematics kinematics)
{
    switch (kinematics) {
        case Kinematics::spatial_deformable:
            return std::make_unique<CoarseSpaceOf<AffineShape<3>>>();
        case Kinematics::spatial_rigid:
            return std::make_unique<CoarseSpaceOf<RigidShape<3>>>();
        case Kinematics::planar_deformable:
            return std::make_unique<CoarseSpaceOf<AffineShape<2>>>();
        case Kinematics::planar_rigid:
            break;
    }
    return std::make_unique<CoarseSpaceOf<RigidShape<2>>>();
}

}  // namespace

CoarseSpace::CoarseSpace() = default;
CoarseSpace::~CoarseSpace() = default;

void CoarseSpace::place(const RowPlaces& places)
{
    if (!implementation_ || kinematics_ != places.kinematics) {
        implementation_ = make(places.kinematics);
        kinematics_ = places.kinematics;
    }
    implementation_->places = places;
}

bool CoarseSpace::prepare(const BlockMatrix& matrix, const ColumnsOf& columns, int threads)
{
    return implementation_ && implementation_->prepare(matrix, columns, threads);
}

void CoarseSpace::factorise()
{
    implementation_->factorise();
}

void CoarseSpace::start(const VectorXd& b, int threads, VectorXd& x)
{
    implementation_->start(b, threads, x);
}

void CoarseSpace::correct(const VectorXd& r, int threads, VectorXd& z)
{
    implementation_->correct(r, threads, z);
}

}  // namespace voussoir::solve
