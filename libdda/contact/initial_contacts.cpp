#include "libdda/contact/initial_contacts.h"

#include <vector>

#include "libdda/contact/find_contacts.h"

namespace voussoir
{

namespace
{

template <int D>
void find_contacts_at_rest(const Model& model, State& state)
{
    std::vector<double> reach(model.blocks.size());
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
        reach[b] = contact::contact_distance * size_of(model, static_cast<int>(b)) + model.fit_tolerance / 2;
    contact::SearchMemory<D> search;
    ContactSetIn<D> contacts;
    contact::find_contacts(model, state, reach, 1, search, contacts, contact::NewOverlap::drawn);
    contacts_in<D>(state) = std::move(contacts);
}

}  // namespace

void find_initial_contacts(const Model& model, State& state)
{
    if (is_planar(model.kinematics))
        find_contacts_at_rest<2>(model, state);
    else
        find_contacts_at_rest<3>(model, state);
}

}  // namespace voussoir
