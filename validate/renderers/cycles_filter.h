/// How Cycles places random samples.
#pragma once

namespace lumaknot::validate {

/// The offset, in pixels, beyond which cycles_filter() is 0.
inline constexpr double kCyclesReach = 1.5017;

/// The density, per pixel, with which Cycles takes samples at `offset` pixels from a pixel's
/// centre, along x and likewise upwards along y, with its default filter: Blackman-Harris, 1.5
/// pixels wide, which ends 1.5 pixels from the centre (the four-term window of Harris, On the Use
/// of Windows for Harmonic Analysis with the Discrete Fourier Transform, Proc. IEEE 66, 1978). It
/// takes offsets from a table of 1,024 entries, which makes the window 0.11 % wider, and whose last
/// is never filled: one sample in 1,023 is spread evenly over [-0.5, 1.5] instead.
double cycles_filter(double offset);

}  // namespace lumaknot::validate
