#pragma once

#include "coupling/case.hpp"
#include "coupling/diagnosis/diagnose.hpp"
#include "coupling/finding/finding.hpp"
#include "coupling/measured/measured_data.hpp"

namespace coupling::finding {

/// Measured data without any curve: whether gap, force and compact of each fitted run fit each
/// other, and which causes stand between them (reduced/pressed_height.hpp). No simulation is asked:
/// one force at one gap is spent on the modulus of the grains. The case gives the press frame and,
/// where the data state none, the density of the grains.
/// @throws dem::InvalidInput as its parts do
Finding diagnose_heights(Case const& setup, measured::MeasuredData const& data,
                         Provenance const& provenance,
                         diagnosis::DiagnosisSettings const& settings = {});

} // namespace coupling::finding
