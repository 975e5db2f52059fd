// Contacts that are strips between an edge of either stone: what slides over a flush bed finds them on the sides
// of the stones of the bed, as high as it is pressed in.
#pragma once

#include <span>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir::contact
{

/// Width of the strip that a contact is, between an edge of either stone [m]; infinite when it is none.
double strip_width(const Model& model, const ContactPatch& patch, std::span<const ContactPoint> points);
double strip_width(const Model& model, const ContactPatchIn<2>& patch, std::span<const ContactPointIn<2>> points);

/// Tells the strips that are there only because joints yield.
template <int D>
class Strips
{
 public:
    /// @param contacts are kept by reference
    Strips(const Model& model, const ContactSetIn<D>& contacts) : model_(model), contacts_(contacts) {}

    /// Whether a contact is a strip that is hardly wider than one of its stones is pressed into its other joints:
    /// the stones pass each other, and nothing lands there.
    bool is_of_yielding(const ContactPatchIn<D>& patch);

 private:
    void find_depths();

    const Model& model_;
    const ContactSetIn<D>& contacts_;
    std::vector<double> depths_;  // m, by block, the deepest joint; of held ones 0; made when first needed
};

}  // namespace voussoir::contact
