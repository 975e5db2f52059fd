#include "app/words/verdict_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "app/words/figures_in_words.h"
#include "app/words/stones_in_words.h"

namespace voussoir::app::words
{

namespace
{

constexpr std::size_t most_named = 5;
constexpr double far_away = 0.5;     // of a stone's size
constexpr double turned_much = 0.1;  // rad: what has turned so far is worth a word

std::string quoted(const Model& model, int block)
{
    return "'" + model.blocks[block].name + "'";
}

std::string names_of(const std::vector<int>& blocks, const Model& model)
{
    std::vector<std::string> names;
    for (const Block& block : model.blocks) names.push_back(block.name);
    return stones_in_words(blocks, names, most_named, "'");
}

/// ", with limited deformation: the joint of 'a' and 'b' is left 3 mm open, 1.2 % of a stone"; empty where no
/// motion was there to do any.
std::string damage_of(const Verdict& verdict, const Model& model)
{
    const Dislocation& worst = verdict.worst;
    const bool opened = worst.opening >= worst.slip;
    if (worst.block_a < 0) return "";
    const std::string joint =
        fmt::format("the joint of {} and {} {} most, by {}, {} of a stone's size", quoted(model, worst.block_a),
                    quoted(model, worst.block_b), opened ? "is left open" : "has slid",
                    length_in_words(opened ? worst.opening : worst.slip), percent_in_words(worst.share));
    switch (verdict.damage) {
        case DamageLevel::none:
            return ", undamaged: " + joint;
        case DamageLevel::limited_deformation:
            return ", with limited deformation: " + joint;
        case DamageLevel::light_damage:
            return ", with light damage: " + joint;
        case DamageLevel::significant_damage:
            break;
    }
    return ", with significant damage: " + joint;
}

/// The stone that has gone furthest and the one that has turned most, where that is much.
std::string whereabouts(const Verdict& verdict, const Model& model)
{
    std::vector<bool> skip(model.blocks.size(), false);
    for (const Foundation& foundation : model.foundations) skip[foundation.block] = true;
    int furthest = -1, most_turned = -1;
    double share = far_away, turn = turned_much;
    for (std::size_t b = 0; b < verdict.blocks.size(); ++b) {
        if (skip[b]) continue;
        const int block = static_cast<int>(b);
        const double far = verdict.blocks[b].displacement / size_of(model, block);
        if (far > share) furthest = block, share = far;
        if (verdict.blocks[b].turn > turn) most_turned = block, turn = verdict.blocks[b].turn;
    }
    std::string words;
    if (furthest >= 0)
        words += fmt::format("; {} is {} from where it stood", quoted(model, furthest),
                             length_in_words(verdict.blocks[static_cast<std::size_t>(furthest)].displacement));
    if (most_turned >= 0)
        words += fmt::format("; {} has turned by {:.3g} deg", quoted(model, most_turned),
                             turn * 180 / std::numbers::pi);
    return words;
}

std::string moving(const Verdict& verdict, const Model& model)
{
    return fmt::format("{} moves at {:.2g} m/s", quoted(model, verdict.fastest), verdict.speed);
}

}  // namespace

std::string in_words(const Verdict& verdict, const Model& model)
{
    const bool carried = verdict.mass > 0;  // else they were thrown, or fell as the run began
    switch (verdict.standing) {
        case Standing::stands:
            return (carried ? "the structure stands" + damage_of(verdict, model) : "all stones lie at rest") +
                   whereabouts(verdict, model);
        case Standing::moves:
            return fmt::format(
                "the {} not come to rest, and how it ends is not known: {} at the end; go on for {:g} s{}",
                carried ? "structure has" : "stones have", moving(verdict, model), verdict.go_on,
                whereabouts(verdict, model));
        case Standing::lost_stones:
        case Standing::fallen:
            break;
    }
    return fmt::format("the structure {}: {} of {} stones ({} of its mass) came off or turned over, {}{}",
                       verdict.standing == Standing::fallen ? "has fallen" : "has lost stones",
                       verdict.lost.size(), model.blocks.size() - model.foundations.size(),
                       percent_in_words(verdict.lost_share), names_of(verdict.lost, model),
                       verdict.fastest >= 0 ? "; what still stands has not come to rest" : "");
}

}  // namespace voussoir::app::words
