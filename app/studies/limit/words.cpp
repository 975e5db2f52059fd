#include <fmt/format.h>

#include "app/studies/limit/study.h"
#include "app/words/stones_in_words.h"
#include "libdda/model/standard_gravity.h"

namespace voussoir::app::studies::limit
{

namespace
{

using voussoir::limit::UnderLoad;

std::string direction_in_words(const LimitStudy& study)
{
    return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", study.towards.x() + 0.0, study.towards.y() + 0.0,
                       study.towards.z() + 0.0);
}

std::string sliding_in_words(const LimitStudy& study)
{
    if (study.bonded_points > 0)
        return "Bonded joints are taken to bear their whole strength at once; real ones break one after another, "
               "so "
               "that the structure may fall under less (run static stages to know).";
    if (!study.sliding)
        return "Of stones that slide without opening no state of equilibrium was found under the weight alone: "
               "friction leaves the limit open (run static stages to know one answer).";
    if (study.sliding->slides_at >= study.associated.factor)
        return "Stones that slide without opening stand up to there as well (to 0.2 %): friction does not leave "
               "the "
               "limit open.";
    return fmt::format(
        "Stones that slide without opening stand up to {:.4f} g; from {:.4f} g on they may slide: between the two "
        "limits friction leaves the answer open.",
        study.sliding->stands_at, study.sliding->slides_at);
}

std::string limit_in_words(const LimitStudy& study)
{
    const std::string towards = direction_in_words(study);
    switch (study.associated.outcome) {
        case UnderLoad::falls_before:
            return "The stones do not stand under their own weight: no forces within friction balance it.";
        case UnderLoad::bears_all:
            return fmt::format("No acceleration towards {} was found that moves the stones.", towards);
        case UnderLoad::unknown:
            return "The iteration did not end: nothing is known.";
        case UnderLoad::limited:
            break;
    }
    return fmt::format(
        "Towards {} the limit is {:.4f} g ({:.4g} m/s2): beyond it no forces within friction balance the stones.",
        towards, study.associated.factor, study.associated.factor * standard_gravity);
}

/// "a | b, c | d and 7 others".
std::string joints_in_words(const LimitStudy& study, bool slides)
{
    constexpr std::size_t most = 8;
    std::vector<std::string> names;
    for (const MovingJoint& joint : study.joints)
        if (joint.slides == slides)
            names.push_back(study.block_names[static_cast<std::size_t>(joint.block_a)] + " | " +
                            study.block_names[static_cast<std::size_t>(joint.block_b)]);
    const std::size_t shown = names.size() <= most + 1 ? names.size() : most;
    std::string text = fmt::format("{}", fmt::join(names.begin(), names.begin() + static_cast<long>(shown), ", "));
    if (shown < names.size()) text += fmt::format(" and {} others", names.size() - shown);
    return text;
}

}  // namespace

std::vector<std::string> in_words(const LimitStudy& study)
{
    std::vector<std::string> sentences{limit_in_words(study)};
    if (study.associated.outcome != UnderLoad::limited) return sentences;
    sentences.push_back(sliding_in_words(study));
    if (study.tilt > 0)
        sentences.push_back(fmt::format("The same of a table that is tilted that way: {:.2f} deg.", study.tilt));
    std::vector<int> blocks;
    blocks.reserve(study.stones.size());
    for (const MovingStone& stone : study.stones) blocks.push_back(stone.block);
    sentences.push_back(fmt::format("Mechanism: {} of {} stones move: {}.", blocks.size(),
                                    study.block_names.size(), words::stones_in_words(blocks, study.block_names)));
    for (const bool slides : {false, true}) {
        const std::string joints = joints_in_words(study, slides);
        if (!joints.empty())
            sentences.push_back(fmt::format("Joints that {}: {}.", slides ? "slide" : "open", joints));
    }
    return sentences;
}

std::string limit_table(const LimitStudy& study)
{
    std::string text =
        fmt::format("limit analysis of {}: {} rigid stones where the case puts them, {} corners of contacts{}\n",
                    study.case_name, study.block_names.size(), study.contact_points,
                    study.bars == 0 ? "" : fmt::format(", {} bars", study.bars));
    if (!study.left_out.empty()) text += fmt::format("left out: {}\n", fmt::join(study.left_out, ", "));
    for (const std::string& sentence : in_words(study)) text += sentence + "\n";
    return text;
}

std::string limit_page(const LimitStudy& study, const std::string& command)
{
    std::string text = fmt::format(
        "# Limit analysis of {}\n\n```sh\n{}\n```\n\n{} rigid stones where the case puts them, {} corners of "
        "contacts, {} bars.\n",
        study.case_name, command, study.block_names.size(), study.contact_points, study.bars);
    if (!study.left_out.empty()) text += fmt::format("Left out: {}.\n", fmt::join(study.left_out, ", "));
    text += "\n";
    for (const std::string& sentence : in_words(study)) text += "- " + sentence + "\n";
    if (study.stones.empty()) return text;
    text +=
        "\n## The mechanism\n\nVelocities over that of the fastest stone, spins per metre.\n\n"
        "| stone | x | y | z | spin x | spin y | spin z |\n|---|---|---|---|---|---|---|\n";
    for (const MovingStone& stone : study.stones)
        text +=
            fmt::format("| {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n",
                        study.block_names[static_cast<std::size_t>(stone.block)], stone.velocity.x(),
                        stone.velocity.y(), stone.velocity.z(), stone.spin.x(), stone.spin.y(), stone.spin.z());
    return text;
}

}  // namespace voussoir::app::studies::limit
