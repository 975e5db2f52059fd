#include "app/results/scene_vectors.h"

namespace voussoir::app::results
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<std::string> axis_names(Kinematics kinematics)
{
    std::vector<std::string> names;
    for (const int axis : axes_of(kinematics)) names.emplace_back(1, static_cast<char>('x' + axis));
    return names;
}

void append_vector(std::vector<double>& values, const Vector3d& v, Kinematics kinematics)
{
    for (const int axis : axes_of(kinematics)) values.push_back(v[axis]);
}

void append_moment(std::vector<double>& values, const Vector3d& moment, Kinematics kinematics)
{
    if (is_planar(kinematics))
        values.push_back(-moment.y());
    else
        append_vector(values, moment, kinematics);
}

std::vector<double> stored_vector(const Vector3d& v, Kinematics kinematics)
{
    std::vector<double> values;
    append_vector(values, v, kinematics);
    return values;
}

Vector3d vector_at(const std::vector<double>& values, std::size_t index, Kinematics kinematics)
{
    Vector3d v = Vector3d::Zero();
    const double* value = values.data() + index * dimension_of(kinematics);
    for (const int axis : axes_of(kinematics)) v[axis] = *value++;
    return v;
}

Vector3d moment_at(const std::vector<double>& values, std::size_t index, Kinematics kinematics)
{
    return is_planar(kinematics) ? Vector3d(0, -values[index], 0) : vector_at(values, index, kinematics);
}

std::vector<std::string> stress_components(const Model& model)
{
    if (!is_deformable(model.kinematics)) return {};
    if (!is_planar(model.kinematics)) return {"xx", "yy", "zz", "xy", "yz", "xz"};
    if (model.plane == PlaneCondition::stress) return {"xx", "zz", "xz"};
    return {"xx", "zz", "xz", "yy"};
}

double component(const Matrix3d& tensor, const std::string& name)
{
    return tensor(name[0] - 'x', name[1] - 'x');
}

Matrix3d tensor_of(const std::vector<std::string>& names, const double* components)
{
    Matrix3d tensor = Matrix3d::Zero();
    for (std::size_t i = 0; i < names.size(); ++i) {
        const int row = names[i][0] - 'x', column = names[i][1] - 'x';
        tensor(row, column) = tensor(column, row) = components[i];
    }
    return tensor;
}

}  // namespace voussoir::app::results
