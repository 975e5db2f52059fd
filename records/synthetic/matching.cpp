#include "records/synthetic/matching.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "libdda/errors.h"
#include "libdda/text/numbers.h"
#include "records/measures/oscillator.h"
#include "records/synthetic/rest.h"
#include "records/synthetic/spectral_scaling.h"

namespace voussoir::records::synthetic
{

namespace
{

using std::numbers::pi;

constexpr double finest = 0.02;      // of the shortest period: the sampling on which the spectrum is judged
constexpr double regularity = 0.02;  // of the wavelets' least squares, as a share of the largest response
constexpr double emphasis = 10;      // weight of the period farthest off, over that of one that is met
constexpr double rivalry = 0.9;      // of the target: a peak to the other side as large as that is watched
constexpr double memory_times = 7;   // an oscillator forgets all but a thousandth in so many decay times
constexpr double fade = 0.03;  // of the duration, at each end, in which the motion grows from and falls to zero

/// A response of one oscillator: signed pseudo-acceleration [m/s2] and its sample.
struct Peak {
    double value = 0;
    std::size_t at = 0;
};

/// The largest responses of one oscillator to either side, the larger one first.
struct Peaks {
    Peak larger, other;
};

/// The largest responses of an oscillator at rest to an acceleration that is linear between samples, looked for at
/// the samples. @param over its influence over a time step
Peaks peaks_of(const measures::Oscillator& oscillator, const measures::Influence& over, double step,
               const std::vector<double>& acceleration)
{
    measures::OscillatorState state;
    Peak highest, lowest;
    for (std::size_t i = 0; i + 1 < acceleration.size(); ++i) {
        const double jerk = (acceleration[i + 1] - acceleration[i]) / step;
        state = measures::advanced(oscillator, over, state, acceleration[i], jerk);
        if (state.displacement > highest.value) highest = {state.displacement, i + 1};
        if (state.displacement < lowest.value) lowest = {state.displacement, i + 1};
    }
    const double stiffness = oscillator.frequency * oscillator.frequency;
    highest.value *= stiffness;
    lowest.value *= stiffness;
    return highest.value > -lowest.value ? Peaks{highest, lowest} : Peaks{lowest, highest};
}

/// The motion on its way: samples on the fine grid and how they respond.
struct Matching {
    double damping = 0.05;
    std::vector<double> periods, wanted;  // s, m/s2
    std::vector<measures::Oscillator> oscillators;
    std::vector<measures::Influence> influences;  // over a step
    double step = 0;                              // s
    std::vector<double> samples;                  // m/s2
    std::vector<Peaks> peaks;
    double worst = 0;  // largest |spectrum / target - 1|
};

double smooth_step(double x)
{
    x = std::clamp(x, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

/// Fades both ends, brings the motion to rest, and measures it.
void settle(Matching& matching)
{
    const double last = static_cast<double>(matching.samples.size() - 1);
    for (std::size_t i = 0; i < matching.samples.size(); ++i) {
        const double x = static_cast<double>(i) / last;
        matching.samples[i] *= smooth_step(std::min(x, 1 - x) / fade);
    }
    bring_to_rest(matching.samples);
    matching.worst = 0;
    for (std::size_t i = 0; i < matching.periods.size(); ++i) {
        matching.peaks[i] =
            peaks_of(matching.oscillators[i], matching.influences[i], matching.step, matching.samples);
        matching.worst =
            std::max(matching.worst, std::abs(std::abs(matching.peaks[i].larger.value) / matching.wanted[i] - 1));
    }
}

/// Amplitudes times target / spectrum, interpolated in the logarithm of the frequency.
void scale_amplitudes(Matching& matching)
{
    std::vector<double> frequencies, factors;
    for (std::size_t i = matching.periods.size(); i-- > 0;) {
        frequencies.push_back(1 / matching.periods[i]);
        factors.push_back(matching.wanted[i] / std::abs(matching.peaks[i].larger.value));
    }
    scale_fourier_amplitudes(frequencies, factors, matching.step, matching.samples);
}

/// A wavelet that oscillator `i` answers with its largest response at its own peak. Its phase makes up for the lag
/// of the response behind the ground ([AlAtikAbrahamson2010], eq. 15 and 16).
struct Wavelet {
    double frequency, centre, width;  // rad/s, s, s
    double at(double time) const
    {
        const double x = (time - centre) / width;
        return std::cos(frequency * (time - centre)) * std::exp(-x * x);
    }
};

Wavelet wavelet_for(const Matching& matching, std::size_t i)
{
    const double damping = matching.damping, root = std::sqrt(1 - damping * damping);
    const double w = 2 * pi / matching.periods[i], wd = w * root;
    const double lag = std::atan(root / damping) / wd;
    const double width = 1.178 * std::pow(1 / matching.periods[i], -0.93);
    return {wd, static_cast<double>(matching.peaks[i].larger.at) * matching.step - lag, width};
}

/// One thing asked of the wavelets: that a response at a time changes by so much.
struct Wish {
    std::size_t oscillator;
    std::size_t at;  // sample
    double change;   // m/s2
    double weight;
};

/// The larger peak of every oscillator to its target. The other one must not take its place: it is held, or
/// lowered with it, when it is nearly as large. What is farthest off weighs most, for the worst period counts.
std::vector<Wish> wishes_of(const Matching& matching)
{
    std::vector<Wish> wishes;
    for (std::size_t i = 0; i < matching.periods.size(); ++i) {
        const auto& [larger, other] = matching.peaks[i];
        const double wanted = matching.wanted[i];
        const double missing = wanted - std::abs(larger.value);
        const double weight = 1 + emphasis * std::pow(missing / wanted / matching.worst, 2);
        wishes.push_back({i, larger.at, larger.value > 0 ? missing : -missing, weight});
        if (std::abs(other.value) < rivalry * wanted) continue;
        const double excess = std::min(0.0, wanted - std::abs(other.value));
        wishes.push_back({i, other.at, other.value > 0 ? excess : -excess, 1});
    }
    return wishes;
}

/// Pseudo-acceleration of an oscillator at one time, for an acceleration: Duhamel's integral as weights of the
/// samples [first, at).
struct Weights {
    std::size_t first = 0;
    std::vector<double> values;
};

Weights weights_of(const Matching& matching, std::size_t oscillator, std::size_t at)
{
    const double damping = matching.damping, w = 2 * pi / matching.periods[oscillator];
    const double wd = w * std::sqrt(1 - damping * damping);
    const auto memory = static_cast<std::size_t>(memory_times / (damping * w * matching.step));
    Weights weights;
    weights.first = at > memory ? at - memory : 0;
    weights.values.resize(at - weights.first);
    for (std::size_t k = weights.first; k < at; ++k) {
        const double since = static_cast<double>(at - k) * matching.step;
        weights.values[k - weights.first] =
            -w * w / wd * std::exp(-damping * w * since) * std::sin(wd * since) * matching.step;
    }
    return weights;
}

/// A wavelet's samples, as far as it is felt.
struct SampledWavelet {
    std::size_t first = 0;
    std::vector<double> values;
};

SampledWavelet sample(const Matching& matching, const Wavelet& wavelet)
{
    const double from = (wavelet.centre - 4 * wavelet.width) / matching.step;
    const double to = (wavelet.centre + 4 * wavelet.width) / matching.step;
    const auto count = static_cast<double>(matching.samples.size());
    SampledWavelet sampled;
    sampled.first = static_cast<std::size_t>(std::clamp(from, 0.0, count));
    sampled.values.resize(static_cast<std::size_t>(std::clamp(to, 0.0, count)) - sampled.first);
    for (std::size_t k = 0; k < sampled.values.size(); ++k)
        sampled.values[k] = wavelet.at(static_cast<double>(sampled.first + k) * matching.step);
    return sampled;
}

/// What every wavelet of amplitude 1 adds where something is wished for.
Eigen::MatrixXd responses(const Matching& matching, const std::vector<Wish>& wishes,
                          const std::vector<SampledWavelet>& wavelets)
{
    const auto rows = static_cast<Eigen::Index>(wishes.size()),
               columns = static_cast<Eigen::Index>(wavelets.size());
    Eigen::MatrixXd response = Eigen::MatrixXd::Zero(rows, columns);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const Wish& wish = wishes[static_cast<std::size_t>(i)];
        const Weights weights = weights_of(matching, wish.oscillator, wish.at);
        for (Eigen::Index j = 0; j < columns; ++j) {
            const SampledWavelet& wavelet = wavelets[static_cast<std::size_t>(j)];
            const std::size_t begin = std::max(weights.first, wavelet.first);
            const std::size_t end =
                std::min(weights.first + weights.values.size(), wavelet.first + wavelet.values.size());
            if (end <= begin) continue;
            const auto length = static_cast<Eigen::Index>(end - begin);
            const Eigen::Map<const Eigen::VectorXd> w(weights.values.data() + (begin - weights.first), length);
            const Eigen::Map<const Eigen::VectorXd> f(wavelet.values.data() + (begin - wavelet.first), length);
            response(i, j) = w.dot(f);
        }
    }
    return response;
}

/// Adds the wavelets that fulfil the wishes in least squares: neighbours are nearly alike, and their amplitudes
/// must stay small.
void add_wavelets(double share, Matching& matching)
{
    std::vector<SampledWavelet> wavelets;
    for (std::size_t i = 0; i < matching.periods.size(); ++i)
        wavelets.push_back(sample(matching, wavelet_for(matching, i)));
    const std::vector<Wish> wishes = wishes_of(matching);
    Eigen::MatrixXd response = responses(matching, wishes, wavelets);
    // Relative changes count, and amplitudes in shares of the target.
    const Eigen::Map<const Eigen::VectorXd> wanted(matching.wanted.data(), response.cols());
    response *= wanted.asDiagonal();
    Eigen::VectorXd change(response.rows());
    for (Eigen::Index i = 0; i < response.rows(); ++i) {
        const Wish& wish = wishes[static_cast<std::size_t>(i)];
        const double scale = wish.weight / matching.wanted[wish.oscillator];
        response.row(i) *= scale;
        change[i] = scale * wish.change;
    }
    const double largest = response.cwiseAbs().maxCoeff();
    Eigen::MatrixXd normal = response.transpose() * response;
    normal.diagonal().array() += std::pow(regularity * largest, 2);
    const Eigen::VectorXd amplitudes = wanted.cwiseProduct(normal.ldlt().solve(response.transpose() * change));
    for (Eigen::Index j = 0; j < response.cols(); ++j) {
        const SampledWavelet& wavelet = wavelets[static_cast<std::size_t>(j)];
        for (std::size_t k = 0; k < wavelet.values.size(); ++k)
            matching.samples[wavelet.first + k] += share * amplitudes[j] * wavelet.values[k];
    }
}

void check(const Channel& seed, const TargetSpectrum& target, const MatchSettings& settings)
{
    std::vector<Fault> faults;
    const auto require = [&](bool good, const std::string& found, const std::string& expected) {
        if (!good) faults.push_back({"matching " + target.name, found, expected});
    };
    const double duration = static_cast<double>(seed.samples.size() - 1) * seed.time_step;
    require(seed.quantity == Quantity::acceleration && has_unit(seed), "a seed that is not an acceleration",
            "give an acceleration with its unit");
    require(settings.shortest > 0 && settings.longest > settings.shortest && settings.periods >= 10,
            text::to_text(settings.shortest) + " to " + text::to_text(settings.longest) + " s",
            "periods must be > 0 and ascending");
    require(duration >= 4 * settings.longest, "a seed of " + text::to_text(duration) + " s",
            "it must last four of the longest periods, " + text::to_text(4 * settings.longest) + " s");
    require(seed.time_step <= 0.25 * settings.shortest, "a time step of " + text::to_text(seed.time_step) + " s",
            "at most a quarter of the shortest period");
    require(target.shortest <= settings.shortest && target.longest >= settings.longest,
            "a target from " + text::to_text(target.shortest) + " to " + text::to_text(target.longest) + " s",
            "it must cover the periods from " + text::to_text(settings.shortest) + " to " +
                text::to_text(settings.longest) + " s");
    require(peak(seed) > 0, "a seed that is zero", "give a motion");
    if (!faults.empty()) throw InputError(std::move(faults));
}

/// The seed on a grid so fine that responses peak at samples; linear between its own.
Matching begin(const Channel& seed, const TargetSpectrum& target, const MatchSettings& settings)
{
    Matching matching;
    matching.damping = target.damping;
    const auto parts = static_cast<std::size_t>(std::ceil(seed.time_step / (finest * settings.shortest)));
    matching.step = seed.time_step / static_cast<double>(parts);
    for (std::size_t i = 0; i + 1 < seed.samples.size(); ++i)
        for (std::size_t k = 0; k < parts; ++k)
            matching.samples.push_back(std::lerp(seed.samples[i], seed.samples[i + 1],
                                                 static_cast<double>(k) / static_cast<double>(parts)));
    matching.samples.push_back(seed.samples.back());
    for (int i = 0; i < settings.periods; ++i) {
        const double share = static_cast<double>(i) / (settings.periods - 1);
        const double period = settings.shortest * std::pow(settings.longest / settings.shortest, share);
        matching.periods.push_back(period);
        matching.wanted.push_back(target.at(period));
        matching.oscillators.push_back({2 * pi / period, target.damping});
        matching.influences.push_back(measures::influence(matching.oscillators.back(), matching.step));
    }
    matching.peaks.resize(matching.periods.size());
    return matching;
}

std::vector<double> spectrum_of(const Matching& matching)
{
    std::vector<double> spectrum;
    for (const Peaks& peaks : matching.peaks) spectrum.push_back(std::abs(peaks.larger.value));
    return spectrum;
}

}  // namespace

Channel match_spectrum(const Channel& seed, const TargetSpectrum& target, const MatchSettings& settings,
                       MatchReport& report)
{
    check(seed, target, settings);
    Matching matching = begin(seed, target, settings);
    for (std::size_t i = 0; i < matching.periods.size(); ++i)
        matching.peaks[i] =
            peaks_of(matching.oscillators[i], matching.influences[i], matching.step, matching.samples);
    report = {matching.periods, matching.wanted, spectrum_of(matching), {}, 0, 0, 0};

    Matching best = matching;
    best.worst = std::numeric_limits<double>::infinity();
    const auto keep_if_better = [&] {
        settle(matching);
        ++report.passes;
        if (matching.worst < best.worst) best = matching;
        return best.worst <= settings.tolerance;
    };
    bool done = keep_if_better();
    for (int pass = 0; pass < settings.spectral_passes && !done; ++pass) {
        scale_amplitudes(matching);
        done = keep_if_better();
    }
    matching = best;
    for (int pass = 0; pass < settings.wavelet_passes && !done; ++pass) {
        add_wavelets(pass < settings.wavelet_passes / 2 ? 1.0 : 0.5, matching);
        done = keep_if_better();
    }

    report.after = spectrum_of(best);
    for (std::size_t i = 0; i < report.periods.size(); ++i) {
        const double apart = std::abs(report.after[i] / report.target[i] - 1);
        if (apart >= report.worst) report.worst = apart, report.worst_period = report.periods[i];
    }
    Channel matched = seed;
    matched.time_step = best.step;
    matched.samples = std::move(best.samples);
    return matched;
}

}  // namespace voussoir::records::synthetic
