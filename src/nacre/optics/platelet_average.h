#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/lane_math.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/optics/fresnel.h"
#include "nacre/optics/thickness_rule.h"
#include "nacre/optics/thin_film.h"

// A platelet is the core between two coats: mirror images of each other, or one of them none, the
// bare interface. For a coat, let r_out be its amplitude reflectance from the binder, r_in the one
// from the core, and tt the product of its transmittances both ways; a dash marks the coat on the far
// side. With w = e^(2 i phase of the core) the platelet has
//     r = r_out + tt r_in' w / (1 - r_in r_in' w),   |t|^2 = |tt tt'| |w| / |1 - r_in r_in' w|^2
// [born-wolf-1999, 7.6 eq. 8-15], the latter as both ways through a coat differ by the admittances
// of its two sides alone. The coat's amplitudes are computed once for each of its thicknesses, then
// averaged over the core's.

namespace nacre::optics {

/// R and T of a platelet at a set of wavelengths, for platelet.cpp.
class PlateletAverage {
 public:
    PlateletAverage(const Platelet& platelet, const Material& binder,
                    std::span<const double> wavelengths_nm, SharedProgress* work)
        : work_(work),
          wavelengths_nm_(wavelengths_nm),
          one_sided_(platelet.coated_sides == Platelet::CoatedSides::one),
          coat_faces_light_(platelet.face == Platelet::Face::coated) {
        if (one_sided_ && platelet.face == Platelet::Face::any) {
            throw DomainError("a platelet coated on one side reflects by the side it is met from");
        }
        films_.push_back(&platelet.core);
        for (const auto& coat : platelet.coats) films_.push_back(&coat);
        for (double w : wavelengths_nm) {
            const ComplexIndex n = binder.index(w);
            if (n.imag() != 0) {
                throw DomainError(fmt::format(
                    "binder \"{}\" absorbs at {} nm (k = {}); give the absorption to the layer "
                    "instead, a flake's reflectance needs a transparent binder",
                    binder.name(), w, n.imag()));
            }
            binder_.push_back(n.real());
        }
        for (const FilmPopulation* film : films_) {
            index_.emplace_back();
            for (double w : wavelengths_nm) index_.back().push_back(film->material.index(w));
        }
        for (std::size_t first = 0; first < wavelengths_nm.size(); first += kLanes) {
            const auto at = [&](const auto& values) {
                return [&values, first](int l) {  // the last block repeats the last wavelength
                    return values[std::min(first + static_cast<std::size_t>(l), values.size() - 1)];
                };
            };
            Block& block = blocks_.emplace_back();
            block.wavelength_nm = make_lanes<DoubleLanes>(at(wavelengths_nm));
            block.binder = make_lanes<DoubleLanes>(at(binder_));
            for (const std::vector<ComplexIndex>& index : index_) {
                const auto n = at(index);
                block.index.push_back(
                    {make_lanes<DoubleLanes>([&](int l) { return n(l).real(); }),
                     make_lanes<DoubleLanes>([&](int l) { return n(l).imag(); })});
            }
        }
        core_spreads_ = films_[0]->spread.standard_deviation_nm > 0;
        if (core_spreads_) arc_ = thickness_arc(films_[0]->thickness_nm, films_[0]->spread);
    }

    /// Chooses and prepares the nodes for a set of cosines.
    void prepare(std::span<const double> cosines) {
        counts_.resize(cosines.size() * blocks_.size());
        parallel_for(0, counts_.size(), [&](std::size_t i) {
            counts_[i] = affordable_counts(std::max(cosines[i / blocks_.size()], kMinCosine),
                                           i % blocks_.size());
        });
        for (std::size_t i = 0; i < counts_.size(); ++i) {
            if (const double all = combinations(counts_[i]); all > kMaxNodes) {
                throw DomainError(fmt::format(
                    "averaging a platelet of {} films over all their spreads takes {:g} "
                    "combinations of thicknesses at cosine {}, more than {:g}; give fewer films a "
                    "spread_nm",
                    films_.size(), all, cosines[i / blocks_.size()], kMaxNodes));
            }
            for (std::size_t f = 0; f < films_.size(); ++f) rules_[{f, counts_[i][f]}];
        }
        std::vector<decltype(rules_)::value_type*> rules;
        for (auto& rule : rules_) rules.push_back(&rule);
        parallel_for(0, rules.size(), [&](std::size_t i) {
            const auto [film, count] = rules[i]->first;
            rules[i]->second =
                thickness_rule(films_[film]->thickness_nm, films_[film]->spread, count);
        });
    }

    void row(std::size_t i, double cosine, double* reflectance, double* transmittance) const {
        cosine = std::max(cosine, kMinCosine);
        std::vector<const ThicknessRule*> rules(films_.size());
        std::vector<ComplexLanes> w;
        Lanes lanes;
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            throw_if_stopped();
            for (std::size_t f = 0; f < films_.size(); ++f) {
                rules[f] = &rules_.at({f, counts_[i * blocks_.size() + b][f]});
            }
            set_interfaces(lanes, cosine, blocks_[b]);
            set_coats(lanes, rules);
            DoubleLanes r{}, t{};
            if (is_opaque(lanes, thinnest_core_nm())) {
                average_opaque(lanes, rules, r);
            } else if (core_spreads_ && lanes.core_transmits) {
                average_arc(lanes, rules, w, r, t);
            } else {
                average_real(lanes, rules, w, r, t);
            }
            store(b, r, reflectance);
            store(b, t, transmittance);
        }
    }

    /// R at one cosine of platelets of which each has one thickness of each film.
    /// @param members  their rules, of one node each, by film
    /// @param stride   of `reflectance` from one to the next
    void row(std::span<const std::vector<ThicknessRule>> members, double cosine,
             double* reflectance, std::size_t stride) const {
        cosine = std::max(cosine, kMinCosine);
        std::vector<const ThicknessRule*> rules(films_.size());
        std::vector<ComplexLanes> w;
        Lanes lanes;
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            throw_if_stopped();
            set_interfaces(lanes, cosine, blocks_[b]);
            for (std::size_t m = 0; m < members.size(); ++m) {
                for (std::size_t f = 0; f < films_.size(); ++f) rules[f] = &members[m][f];
                set_coats(lanes, rules);
                DoubleLanes r{}, t{};
                if (is_opaque(lanes, rules[0]->thickness_nm[0])) {
                    average_opaque(lanes, rules, r);
                } else {
                    average_real(lanes, rules, w, r, t);
                }
                store(b, r, reflectance + m * stride);
            }
        }
    }

 private:
    // Relative errors aimed at in the mean over each film's thickness: the first one whose nodes number
    // at most kMaxNodes is used.
    static constexpr double kTargetErrors[] = {1e-7, 1e-5, 1e-4};
    // Of light that goes through a film and back, the part of its amplitude below which its thickness does
    // not matter: R and T change by less than twice as much.
    static constexpr double kOpaque = 1e-12;
    static constexpr double kMinCosine = 1e-9;  // in place of 0, where the amplitudes are 0/0
    static constexpr double kMaxNodes = 1e6;    // product over the films: some seconds of work

    /// Refractive indices at one lane vector of wavelengths.
    struct Block {
        DoubleLanes wavelength_nm, binder;
        std::vector<ComplexLanes> index;  // [film]
    };

    /// Wave vectors and interfaces at one cosine for one lane vector of wavelengths.
    struct Lanes {
        /// e^(i phase_rate d) is a film's factor for the way there and back; core first.
        std::vector<ComplexLanes> phase_rate;
        /// These factors for each thickness of a coat: [film][node]; none of the core's.
        std::vector<std::vector<ComplexLanes>> round_trip;
        /// Reflectance amplitude of the interfaces, from outside: binder | last coat, ..., first coat |
        /// core; for s and p.
        std::vector<ComplexLanes> interface[2];
        ComplexLanes bare[2];        ///< binder | core
        bool core_transmits = true;  ///< the core is transparent and below its critical angle
    };

    void throw_if_stopped() const {
        if (work_) work_->throw_if_stopped("computing the films of a flake");
    }

    double thinnest_core_nm() const {
        return thickness_range(films_[0]->thickness_nm, films_[0]->spread).lo_nm;
    }

    /// The mean of both polarisations, whose sum is given, at the wavelengths of a block.
    void store(std::size_t block, const DoubleLanes& sum, double* row) const {
        const std::size_t first = block * kLanes;
        const std::size_t count = std::min<std::size_t>(kLanes, wavelengths_nm_.size() - first);
        for (std::size_t l = 0; l < count; ++l) row[first + l] = sum[l] / 2;
    }

    /// Whether nothing comes back from the far side of a core, at any of the wavelengths.
    static bool is_opaque(const Lanes& lanes, double core_nm) {
        const double decay_per_nm = -std::log(kOpaque) / core_nm;
        for (int l = 0; l < kLanes; ++l) {
            if (lanes.phase_rate[0].im[l] < decay_per_nm) return false;
        }
        return true;
    }

    void set_interfaces(Lanes& lanes, double cosine, const Block& block) const {
        const std::size_t count = films_.size();
        lanes.core_transmits = true;
        lanes.phase_rate.resize(count);
        for (auto& list : lanes.interface) list.resize(count);
        const DoubleLanes none{};
        ComplexLanes y_s{block.binder * cosine, none}, y_p{cosine / block.binder, none};
        for (std::size_t f = count; f-- > 0;) {
            const ComplexLanes n = block.index[f];
            ComplexLanes q = normal_wavevector(block.binder, n, cosine);
            if (f == 0) {
                for (int l = 0; l < kLanes; ++l) {
                    if (n.im[l] != 0 || q.im[l] != 0) lanes.core_transmits = false;
                }
            }
            // Exactly at the critical angle both waves in the film are the same, and the sums
            // below would be 0/0; moving q by 1e-9 changes R and T by as little.
            constexpr double lower_bound = 1e-9;
            const DoubleLanes above = norm(q) - lower_bound * lower_bound;
            q = {where_positive(above, q.re, splat(lower_bound)),
                 where_positive(above, q.im, none)};
            const ComplexLanes below_s = q, below_p = q / (n * n);
            lanes.interface[0][count - 1 - f] = (y_s - below_s) / (y_s + below_s);
            lanes.interface[1][count - 1 - f] = (y_p - below_p) / (y_p + below_p);
            lanes.phase_rate[f] = (4 * std::numbers::pi / block.wavelength_nm) * q;
            if (f == 0) {
                const ComplexLanes s{block.binder * cosine, none}, p{cosine / block.binder, none};
                lanes.bare[0] = (s - below_s) / (s + below_s);
                lanes.bare[1] = (p - below_p) / (p + below_p);
            }
            y_s = below_s;
            y_p = below_p;
        }
    }

    void set_coats(Lanes& lanes, const std::vector<const ThicknessRule*>& rules) const {
        const std::size_t count = films_.size();
        lanes.round_trip.resize(count);
        for (std::size_t f = 1; f < count; ++f) {
            lanes.round_trip[f].clear();
            const ComplexLanes& rate = lanes.phase_rate[f];
            bool decays = false;
            for (int l = 0; l < kLanes; ++l) decays = decays || rate.im[l] != 0;
            for (double thickness_nm : rules[f]->thickness_nm) {
                lanes.round_trip[f].push_back(decays ? exp_i(splat(thickness_nm) * rate)
                                                     : cis_lanes(thickness_nm * rate.re));
            }
        }
    }

    struct Coat {
        ComplexLanes r_out, r_in, tt;
    };
    /// A bare interface.
    static Coat bare_interface(const ComplexLanes& f) {
        return {f, -f, splat_complex(1.0) - f * f};
    }

    /// Calls use(near, far, weight), with the coats on the side of the light and on the other, for
    /// both polarisations and every combination of the coats' thicknesses.
    template <class Use>
    void for_each_coat(const Lanes& lanes, const std::vector<const ThicknessRule*>& rules,
                       const Use& use) const {
        Coat start[2], bare[2];
        for (int p = 0; p < 2; ++p) {
            start[p] = bare_interface(lanes.interface[p][0]);
            bare[p] = bare_interface(lanes.bare[p]);
        }
        add_coats(lanes, rules, films_.size() - 1, 0, start, 1.0,
                  [&](const Coat* coat, double weight) {
                      for (int p = 0; p < 2; ++p) {
                          if (!one_sided_) {
                              use(coat[p], coat[p], weight);
                          } else if (coat_faces_light_) {
                              use(coat[p], bare[p], weight);
                          } else {
                              use(bare[p], coat[p], weight);
                          }
                      }
                  });
    }

    /// Adds film `film` and those below it, as far as the one above `end`, under the coats in `above`.
    template <class Use>
    void add_coats(const Lanes& lanes, const std::vector<const ThicknessRule*>& rules,
                   std::size_t film, std::size_t end, const Coat (&above)[2], double weight,
                   const Use& use) const {
        if (film == end) {
            use(above, weight);
            return;
        }
        throw_if_stopped();  // up to a million combinations of thicknesses follow
        const ThicknessRule& rule = *rules[film];
        for (std::size_t i = 0; i < rule.weights.size(); ++i) {
            const ComplexLanes& e = lanes.round_trip[film][i];
            Coat next[2];
            for (int p = 0; p < 2; ++p) {
                const Coat& a = above[p];
                const ComplexLanes& f = lanes.interface[p][films_.size() - film];
                const ComplexLanes bounce =
                    splat_complex(1.0) / (splat_complex(1.0) - a.r_in * e * f);
                const ComplexLanes through = splat_complex(1.0) - f * f;
                const ComplexLanes e_bounce = e * bounce;
                next[p] = {a.r_out + a.tt * f * e_bounce, through * a.r_in * e_bounce - f,
                           a.tt * through * e_bounce * bounce};
            }
            add_coats(lanes, rules, film - 1, end, next, weight * rule.weights[i], use);
        }
    }

    /// On an opaque core: R = |r_out|^2, T = 0. With the factor e of the innermost coat,
    /// r_out = r + tt f e / (1 - r_in f e), where r, r_in and tt are those of the coats above it and f
    /// is the interface to the core; over one denominator that costs one division.
    void average_opaque(const Lanes& lanes, const std::vector<const ThicknessRule*>& rules,
                        DoubleLanes& r) const {
        if (films_.size() == 1 || (one_sided_ && !coat_faces_light_)) {
            for (const ComplexLanes& bare : lanes.bare) r += norm(bare);
            return;
        }
        Coat start[2];
        for (int p = 0; p < 2; ++p) start[p] = bare_interface(lanes.interface[p][0]);
        const std::vector<double>& weights = rules[1]->weights;
        add_coats(lanes, rules, films_.size() - 1, 1, start, 1.0,
                  [&](const Coat* above, double weight) {
                      for (int p = 0; p < 2; ++p) {
                          const ComplexLanes& f = lanes.interface[p].back();
                          const ComplexLanes b = above[p].r_in * f;
                          const ComplexLanes a = above[p].tt * f - above[p].r_out * b;
                          DoubleLanes sum{};
                          for (std::size_t i = 0; i < weights.size(); ++i) {
                              const ComplexLanes& e = lanes.round_trip[1][i];
                              sum += weights[i] * norm(above[p].r_out + a * e) /
                                     norm(splat_complex(1.0) - b * e);
                          }
                          r += weight * sum;
                      }
                  });
    }

    /// The general case: every thickness of the core by itself.
    void average_real(const Lanes& lanes, const std::vector<const ThicknessRule*>& rules,
                      std::vector<ComplexLanes>& w, DoubleLanes& r, DoubleLanes& t) const {
        const ThicknessRule& core = *rules[0];
        const std::size_t count = core.weights.size();
        w.resize(count);
        for (std::size_t j = 0; j < count; ++j) {
            w[j] = exp_i(splat(core.thickness_nm[j]) * lanes.phase_rate[0]);
        }
        std::vector<DoubleLanes> w_abs(count);
        for (std::size_t j = 0; j < count; ++j) {
            w_abs[j] = exp_lanes(-core.thickness_nm[j] * lanes.phase_rate[0].im);
        }
        for_each_coat(lanes, rules, [&](const Coat& coat, const Coat& far, double weight) {
            const ComplexLanes p = coat.r_in * far.r_in;
            const ComplexLanes b = coat.tt * far.r_in - coat.r_out * p;
            DoubleLanes sum_r{}, sum_t{};
            for (std::size_t j = 0; j < count; ++j) {
                const DoubleLanes fraction = core.weights[j] / norm(splat_complex(1.0) - p * w[j]);
                sum_r += fraction * norm(coat.r_out + b * w[j]);
                sum_t += fraction * w_abs[j];
            }
            r += weight * sum_r;
            t += weight * through(coat, far) * sum_t;
        });
    }

    /// |tt tt'|.
    DoubleLanes through(const Coat& coat, const Coat& far) const {
        return one_sided_ ? sqrt_lanes(norm(coat.tt) * norm(far.tt)) : norm(coat.tt);
    }

    /// For |w| = 1 on the real axis. With p = r_in r_in', 1/|1 - p w|^2 is the real part of
    /// (1 + p w)/(1 - p w) over 1 - |p|^2, the Poisson kernel; so R and T follow from the mean of
    /// w/(1 - p w) alone, which is analytic and can be averaged on an arc.
    void average_arc(const Lanes& lanes, const std::vector<const ThicknessRule*>& rules,
                     std::vector<ComplexLanes>& w, DoubleLanes& r, DoubleLanes& t) const {
        const std::size_t count = arc_.weights.size();
        w.resize(2 * count);  // w, and w times the weight
        for (std::size_t j = 0; j < count; ++j) {
            w[2 * j] = exp_i(splat_complex(arc_.thickness_nm[j]) * lanes.phase_rate[0]);
            w[2 * j + 1] = splat_complex(arc_.weights[j]) * w[2 * j];
        }
        for_each_coat(lanes, rules, [&](const Coat& coat, const Coat& far, double weight) {
            const ComplexLanes p = coat.r_in * far.r_in;
            ComplexLanes mean{};
            for (std::size_t j = 0; j < count; ++j) {
                mean = mean + w[2 * j + 1] / (splat_complex(1.0) - p * w[2 * j]);
            }
            const ComplexLanes back = coat.tt * far.r_in;
            // With two alike, 1 - |p|^2 is (1 - |r_in|^2)(1 + |r_in|^2), and 1 - |r_in|^2 >= |tt|,
            // for no coat amplifies; with two that differ, it is at least the larger of both |tt|.
            // Where the difference is below rounding, the bound replaces it; where tt = 0, the
            // quotient is multiplied by 0 and any positive number will do.
            constexpr double tiny = 1e-300;
            const DoubleLanes lower_bound =
                (one_sided_ ? sqrt_lanes(max_lanes(norm(coat.tt), norm(far.tt)))
                            : sqrt_lanes(norm(coat.tt)) * (1.0 + norm(coat.r_in))) +
                tiny;
            const DoubleLanes kernel =
                (1.0 + 2.0 * (p * mean).re) / max_lanes(1.0 - norm(p), lower_bound);
            r += weight * (norm(coat.r_out) + 2.0 * (conj(coat.r_out) * back * mean).re +
                           norm(back) * kernel);
            t += weight * through(coat, far) * kernel;
        });
    }

    /// Those of the smallest error aimed at that is affordable, else of the largest.
    std::vector<int> affordable_counts(double cosine, std::size_t block) const {
        std::vector<int> counts;
        for (double target_error : kTargetErrors) {
            counts = node_counts(cosine, block, target_error);
            if (combinations(counts) <= kMaxNodes) break;
        }
        return counts;
    }

    double combinations(const std::vector<int>& counts) const {
        double all = core_spreads_ ? static_cast<double>(arc_.weights.size()) : 1.0;
        all = std::max<double>(all, counts[0]);
        for (std::size_t f = 1; f < counts.size(); ++f) all *= counts[f];
        return all;
    }

    /// Of thicknesses, by film: as many as the wavelength of the block needs that needs most.
    std::vector<int> node_counts(double cosine, std::size_t block, double target_error) const {
        const std::size_t count = films_.size();
        std::vector<int> nodes(count, 1);
        const bool spread = std::any_of(films_.begin(), films_.end(), [](const FilmPopulation* f) {
            return f->spread.standard_deviation_nm > 0;
        });
        if (!spread) return nodes;
        // Amplitudes in s are the larger ones; two interfaces together reflect at most
        // (a + b)/(1 + a b).
        const auto together = [](double a, double b) { return (a + b) / (1 + a * b); };
        std::vector<double> face(count), rate(count), decay(count);
        const std::size_t end = std::min((block + 1) * kLanes, wavelengths_nm_.size());
        for (std::size_t j = block * kLanes; j < end; ++j) {
            std::complex<double> y = binder_[j] * cosine;
            std::vector<double> outward(count);
            for (std::size_t f = count; f-- > 0;) {
                const auto q = normal_wavevector(binder_[j], index_[f][j], cosine);
                face[f] = y == q ? 0.0 : std::abs((y - q) / (y + q));
                outward[f] = f + 1 < count ? together(outward[f + 1], face[f]) : face[f];
                rate[f] = 4 * std::numbers::pi / wavelengths_nm_[j] * std::abs(q);
                decay[f] = 4 * std::numbers::pi / wavelengths_nm_[j] * q.imag();
                y = q;
            }
            // Amplitude returned from the far side of the core, averaged over its thickness: the
            // mean of e^(i phase) over a normal law is exp(-(deviation of the phase)^2 / 2).
            const double core_phase = rate[0] * films_[0]->spread.standard_deviation_nm;
            double inward = std::exp(-core_phase * core_phase / 2 - decay[0] * thinnest_core_nm());
            for (std::size_t f = 0; f < count; ++f) {
                const auto& spread = films_[f]->spread;
                // Where average_arc() is used, the core needs no nodes of its own.
                const bool on_arc = f == 0 && decay[0] == 0;
                if (spread.standard_deviation_nm > 0 && !on_arc) {
                    const auto [lo, hi] = thickness_range(films_[f]->thickness_nm, spread);
                    const double back = f == 0 ? outward[0] : inward;
                    const double passing = std::exp(-decay[f] * lo);
                    const bool evanescent = index_[f][j].imag() == 0 && decay[f] > 0;
                    if (passing > kOpaque) {
                        nodes[f] = std::max(
                            nodes[f],
                            evanescent ? nodes_for_decay(lo, hi, decay[f], target_error)
                                       : nodes_for_wave(rate[f] * (hi - lo) / 2,
                                                        outward[f] * back * passing, target_error));
                    }
                }
                inward = together(inward, face[f]);
            }
        }
        return nodes;
    }

    SharedProgress* work_;
    std::span<const double> wavelengths_nm_;
    std::vector<const FilmPopulation*> films_;  // core first
    std::vector<double> binder_;
    std::vector<std::vector<ComplexIndex>> index_;  // [film][wavelength]
    std::vector<Block> blocks_;
    bool one_sided_, coat_faces_light_;
    bool core_spreads_ = false;
    ThicknessArc arc_;
    std::map<std::pair<std::size_t, int>, ThicknessRule> rules_;  // by film and count
    std::vector<std::vector<int>> counts_;                        // [cosine][block][film]
};

}  // namespace nacre::optics
