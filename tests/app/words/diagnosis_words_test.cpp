// The sentences that users read, word for word: they are in summaries and study pages.
#include "app/words/diagnosis_words.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace voussoir::testing
{

namespace
{

/// Six blocks: base, drum, cap, a, b, c.
Model six_blocks()
{
    Model model = make_model(Kinematics::spatial_rigid, {"stone", 2000, 1e10, 0.2}, {});
    for (const char* name : {"base", "drum", "cap", "a", "b", "c"})
        model.blocks.push_back(make_block(name, 0, 0, {make_box({0, 0, 0}, {1, 1, 1})}));
    return model;
}

std::vector<Stage> one_stage()
{
    Stage stage;
    stage.name = "motion";
    return {stage};
}

using Sentence = std::pair<Diagnosis, std::string>;

const Sentence sentences[] = {
    {{DiagnosisKind::inverted_block, 0, {1}, {0.12345678, 12, 1e-9, 0.0123456789}},
     "stage 'motion' failed to converge at t = 0.123457 s: the time step was cut 12 times to below 1e-09 s; block "
     "'drum' would be inverted: its stone is too soft for its load, or the step too long for the impact; try a "
     "smaller time_step, a higher modulus or a rigid scene"},
    {{DiagnosisKind::singular_system, 0, {1}, {0.12345678, 12, 1e-9, 0.0123456789}},
     "stage 'motion' failed to converge at t = 0.123457 s: the time step was cut 12 times to below 1e-09 s; block "
     "'drum' keeps an unbalanced force of 0.0123457 of its load and is in a system of equations that cannot be "
     "solved: stiffnesses or masses differ by too many orders of magnitude; look at the contact_stiffness and the "
     "size of that block's neighbours"},
    {{DiagnosisKind::inaccurate_solution, 0, {1}, {0.12345678, 12, 1e-9, 0.0123456789}},
     "stage 'motion' failed to converge at t = 0.123457 s: the time step was cut 12 times to below 1e-09 s; block "
     "'drum' keeps an unbalanced force of 0.0123457 of its load and has forces below the rounding error: its "
     "contacts or its stone are too stiff for its mass and the step, or the coordinates too large; try a lower "
     "contact_stiffness or a larger time_step, and coordinates near the origin"},
    {{DiagnosisKind::chatter, 0, {1}, {0.12345678, 12, 1e-9, 0.0123456789}},
     "stage 'motion' failed to converge at t = 0.123457 s: the time step was cut 12 times to below 1e-09 s; block "
     "'drum' keeps an unbalanced force of 0.0123457 of its load and has contacts that keep switching between "
     "open, sticking and sliding; try a larger force_tolerance, a smaller time_step or a relaxation_time in its "
     "joints, and look for overlapping or extremely stiff neighbours"},
    {{DiagnosisKind::unbalanced, 0, {1}, {0.12345678, 12, 1e-9, 0.0123456789}},
     "stage 'motion' failed to converge at t = 0.123457 s: the time step was cut 12 times to below 1e-09 s; block "
     "'drum' keeps an unbalanced force of 0.0123457 of its load and keeps an unbalanced force; try a smaller "
     "time_step or a larger force_tolerance"},
    {{DiagnosisKind::chatter, 0, {}, {0.12345678, 12, 1e-9, 0.0123456789}},
     "stage 'motion' failed to converge at t = 0.123457 s: the time step was cut 12 times to below 1e-09 s; try a "
     "smaller time_step"},
    {{DiagnosisKind::too_many_cuts, 0, {1}, {0.12345678, 2e-3, 20000, 1.25e-7}},
     "stage 'motion' stopped at t = 0.123457 s: a nominal step of 0.002 s needed more than 20000 cut ones, the "
     "last of 1.25e-07 s; block 'drum' converges worst: look at its joints; a lower contact_stiffness, a "
     "relaxation_time or a larger force_tolerance may help"},
    {{DiagnosisKind::too_many_cuts, 0, {}, {0.12345678, 2e-3, 20000, 1.25e-7}},
     "stage 'motion' stopped at t = 0.123457 s: a nominal step of 0.002 s needed more than 20000 cut ones, the "
     "last of 1.25e-07 s"},
    {{DiagnosisKind::no_equilibrium, 0, {}, {1234567, 0.0123456789}},
     "stage 'motion' found no equilibrium in 1234567 steps: the unbalanced force is still 0.0123457 of a block's "
     "load, though no block falls; try gravity_increments, a larger unbalanced_tolerance or max_static_steps, or "
     "a "
     "contact_stiffness nearer to that of the stones"},
    {{DiagnosisKind::deep_overlap, 0, {1, 0}, {0.12345678, 0.02, 0.123456789, 0, 3, 0.009}},
     "stage 'motion' stopped at t = 0.123457 s: blocks 'drum' and 'base' overlap by 0.02 m, 12.3457 % of the "
     "thinner one's width, at t = 3 s: the contact is too soft for its load or its impact; give the joint a "
     "contact_stiffness 124 times as large"},
    {{DiagnosisKind::deep_overlap, 0, {1, 0}, {0, 0.02, 0.123456789, 0, 0, 0.02}},
     "stage 'motion' stopped at t = 0 s: blocks 'drum' and 'base' overlap by 0.02 m, 12.3457 % of the thinner "
     "one's "
     "width, at t = 0 s: 0.02 m of it is drawn, beyond the fit_tolerance of 0 m; trim or move one of them by "
     "this, "
     "or give a larger fit_tolerance if it is an error of the survey"},
    {{DiagnosisKind::mechanism, 0, {2}, {0.12345678, 0.6, -1e-9, -0.8}},
     "stage 'motion' finds no equilibrium: 1 of 6 blocks is falling: 'cap', 0.123 m towards [0.6, 0, -0.8]; look "
     "at "
     "what should carry it, or add it to the foundation"},
    {{DiagnosisKind::mechanism, 0, {5, 4, 3, 2, 1, 0}, {6, 0, 0, -1, 5, 0, 0, -1, 4, 0, 0, -1,
                                                        3, 0, 0, -1, 2, 0, 0, -1, 1, 0, 0, -1}},
     "stage 'motion' finds no equilibrium: 6 of 6 blocks are falling: 'c', 6 m towards [0, 0, -1]; 'b', 5 m "
     "towards "
     "[0, 0, -1]; 'a', 4 m towards [0, 0, -1]; 'cap', 3 m towards [0, 0, -1]; 'drum', 2 m towards [0, 0, -1]; "
     "...; "
     "look at what should carry them, or add them to the foundation"},
    {{DiagnosisKind::deep_overlap, 0, {1, 0}, {0.12345678, 0.02, 0.123456789, 0.015, 3, 0}},
     "stage 'motion' stopped at t = 0.123457 s: blocks 'drum' and 'base' overlap by 0.02 m, 12.3457 % of the "
     "thinner one's width, at t = 3 s: 0.015 m of it is free of stress, because their contact was detected late "
     "or alternates between two faces; try time_step: 0.5 ms, and look at bearing edges and corners"},
    {{DiagnosisKind::overlap, -1, {1, 0}, {0.02, 0.123456789, 0, 3, 0}},
     "blocks 'drum' and 'base' overlapped by 0.02 m, 12.3457 % of the thinner one's width, at t = 3 s: contacts "
     "this soft influence the results, and the integrator damps their vibration, most strongly with newmark; give "
     "the joint a contact_stiffness 124 times as large"},
    {{DiagnosisKind::overlap, -1, {1, 0}, {0.02, 0.123456789, 0.015, 3, 0}},
     "blocks 'drum' and 'base' overlapped by 0.02 m, 12.3457 % of the thinner one's width, at t = 3 s: 0.015 m of "
     "it is free of stress, because their contact was detected late or alternates between two faces; try "
     "time_step: 0.5 ms, and look at bearing edges and corners"},
    {{DiagnosisKind::energy_from_nowhere, 0, {1}, {0.12345678, 60.0 / 90, 3.5}},
     "stage 'motion' stopped at t = 0.123457 s: 66.6667 % of the energy is unaccounted for (a gain); the fastest "
     "block is 'drum' with 3.5 m/s: the forces are not solved well enough for the step; try time_step: 0.5 ms, "
     "or force_tolerance: 1e-06"},
    {{DiagnosisKind::energy_unaccounted, -1, {}, {60.0 / 90}},
     "66.6667 % of the energy is unaccounted for (limit 1 %): do not trust this run; try time_step: 0.5 ms, or "
     "force_tolerance: 1e-06"},
    {{DiagnosisKind::energy_vanished, 0, {1}, {0.12345678, 40.0 / 90, 3.5}},
     "stage 'motion' stopped at t = 0.123457 s: 44.4444 % of the energy is unaccounted for (a loss); the fastest "
     "block is 'drum' with 3.5 m/s: the forces are not solved well enough for the step; try time_step: 0.5 ms, "
     "or force_tolerance: 1e-06"},
    {{DiagnosisKind::energy_from_contacts, 0, {}, {0.12345678, 0.15}},
     "stage 'motion' stopped at t = 0.123457 s: after the next step, however short, 15 % of the energy would have "
     "come from contacts whose area grew or that were detected late under compression: impacts are too strong; "
     "try time_step: 0.5 ms, and look for "
     "impacts on edges and corners"},
    {{DiagnosisKind::energy_given, -1, {}, {0.15}},
     "15 % of the energy came from contacts whose area grew or that were detected late under compression: "
     "impacts are too strong; try time_step: 0.5 ms, and look for impacts on edges and corners"},
    {{DiagnosisKind::energy_no_number, 0, {1}, {0.12345678}},
     "stage 'motion' stopped at t = 0.123457 s: an energy is not a finite number; the fastest block is 'drum'; "
     "look at its joints' stiffness and its motion"},
    {{DiagnosisKind::no_number, 0, {0}, {0.12345678}},
     "stage 'motion' stopped at t = 0.123457 s: block 'base' has a position or velocity that is not a finite "
     "number; look at its mass, its joints and its motion"},
    {{DiagnosisKind::ground_jump, 0, {0}, {0.02}},
     "stage 'motion' starts with a velocity jump of the ground: 0.02 m/s at block 'base'; let motions start and "
     "end at rest (taper, end_correction), or make one stage of two"},
    {{DiagnosisKind::fallen, -1, {2, 1}, {1.25, 2}}, "2 of 6 blocks have fallen: 'cap' at 1.25 s, 'drum' at 2 s"},
    {{DiagnosisKind::fallen, -1, {0, 1, 2, 3, 4, 5}, {1, 2, 3, 4, 5, 6}},
     "6 of 6 blocks have fallen: 'base' at 1 s, 'drum' at 2 s, 'cap' at 3 s, 'a' at 4 s, 'b' at 5 s, ..."},
    {{DiagnosisKind::crushed_joints, -1, {0, 1}, {2, 2.5, 0.2, 0.35, 0}},
     "2 joints exceed their compressive strength, longest 'base' on 'drum': for 0.35 s in all, up to 2.5 times at "
     "0.2 s"},
    {{DiagnosisKind::crushed_joints, -1, {0, 1}, {1, 2.5, 0.2, 0, 30}},
     "1 joints exceed their compressive strength, longest 'base' on 'drum': at rest, up to 2.5 times at 0.2 s; 30 "
     "more only as briefly as impacts last"},
    {{DiagnosisKind::dry_joints, -1, {0, 1}, {3, 0.00125}},
     "3 contacts have cohesion or tensile strength but are open at a corner, the widest by 0.00125 m between "
     "'base' and 'drum': they are dry from the start; close them in the model to within a ten-thousandth of the "
     "stones' size"},
    {{DiagnosisKind::undecided, 0, {}, {1, 2, 0.01, 1}},
     "whether the structure stands in stage 'motion' is undecided: with steps of 1 s it falls, with steps of 0.01 "
     "s "
     "and the weight in increments it comes to rest, and limit analysis does not agree with both; it is near its "
     "limit, or the answer depends on how it was built: vary friction and load a little, or load it in stages"},
    {{DiagnosisKind::friction_open, 0, {}, {2, 1}},
     "friction leaves open whether the structure stands in stage 'motion': forces within friction balance its "
     "stones as rigid ones, but here it falls; how it was built and loaded, or how far stones and joints give "
     "way, "
     "decides"},
    {{DiagnosisKind::friction_open, 0, {}, {1, 0}},
     "friction leaves open whether the structure stands in stage 'motion': here it comes to rest, but its joints "
     "can "
     "press in ways with which it stands, and in others with which it slides; how it was built and loaded "
     "decides"},
    {{DiagnosisKind::interrupted, -1, {}, {}}, "stopped on request"},
};

}  // namespace

TEST(DiagnosisWords, NameStageBlocksCauseAndRemedy)
{
    const Model model = six_blocks();
    for (const auto& [diagnosis, words] : sentences) {
        ASSERT_TRUE(is_whole(diagnosis)) << diagnosis;
        EXPECT_EQ(app::words::in_words(diagnosis, model, one_stage()), words) << diagnosis;
    }
}

TEST(DiagnosisWords, AreTriedForEveryKind)
{
    std::set<DiagnosisKind> tried;
    for (const auto& [diagnosis, words] : sentences) tried.insert(diagnosis.kind);
    EXPECT_EQ(tried.size(), diagnosis_kinds);
}

TEST(DiagnosisWords, OfAReportAreItsMessageAndItsWarnings)
{
    const Model model = six_blocks();
    RunReport report;
    EXPECT_EQ(app::words::message_of(report, model, one_stage()), "");
    EXPECT_TRUE(app::words::warnings_of(report, model, one_stage()).empty());
    report.diagnosis = sentences[0].first;
    report.warnings = {sentences[1].first, sentences[2].first};
    EXPECT_EQ(app::words::message_of(report, model, one_stage()), sentences[0].second);
    EXPECT_EQ(app::words::warnings_of(report, model, one_stage()),
              (std::vector{sentences[1].second, sentences[2].second}));
}

}  // namespace voussoir::testing
