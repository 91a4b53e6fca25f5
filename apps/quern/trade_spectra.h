// Peaks and moments of the spectrum of collisions, over all kinds, with errors from blocks.
#pragma once

#include <string>
#include <vector>

namespace quern {

struct SpectrumFigure {
  std::string name, label;
  double value = 0, standard_error = 0;  // decades: log10 of an energy in J
};

// `count` and `energy`: what the bins of all kinds had come to at the end of each block (kinds x
// kEnergyBins). Energies: the most frequent one, the one at which most is dissipated, the mean of
// log10 E over collisions and over what they dissipate, and its standard deviation over collisions.
// Bins below 1e-12 J and above 1e3 J are open and do not count.
std::vector<SpectrumFigure> spectrum_figures(const std::vector<std::vector<double>>& count,
                                             const std::vector<std::vector<double>>& energy);

// Place (decades) of the highest point of a parabola through the bins half a decade about the
// largest one of the smoothed histogram; NaN where it is empty.
double spectrum_peak(const std::vector<double>& bins);

}  // namespace quern
