//! Frames along a line whose parts spin, built as rotors.

use crate::answer::network::questions::FrameAnalysis;
use crate::answer::orbit::{Orbit, steady_motion};
use crate::element::MemberSpins;
use crate::frame::{BuildErrors, DampedRotorStructure, Frame, Framework, InFrame, Line, RotorStructure};
use crate::model::{MotionError, PlaneEntry, PlaneLoad};
use crate::search::rotor::{Rotor, Spinning};
use num_complex::Complex;

impl Frame<Line> {
    /// Builds the rotor, if nothing in it is damped. What names no speed stands still.
    ///
    /// ```
    /// use mstmm_core::elements::{Disc, Spring};
    /// use mstmm_core::frame::{Frame, Ground, Section};
    /// use mstmm_core::search::NaturalFrequencies;
    /// use mstmm_core::Whirl;
    ///
    /// let mut frame = Frame::new();
    /// let speed = 400.0;
    /// let points = [0.0, 0.5, 1.0, 1.5].map(|x| frame.point(x));
    /// let shaft = Section::new().bending_stiffness(6.5e4).mass_per_length(15.3).rotary_inertia(2.4e-3);
    /// let shaft = shaft.polar_inertia_per_length(4.8e-3).speed(speed);
    /// for pair in points.windows(2) {
    ///     frame.member(pair[0], pair[1], shaft);
    /// }
    /// frame.body([points[1]], Disc { mass: 33.0, inertia: 0.18, polar_inertia: 0.32, speed });
    /// frame.body([points[2]], Disc { mass: 51.0, inertia: 0.42, polar_inertia: 0.79, speed });
    /// for end in [points[0], points[3]] {
    ///     frame.member(end, Ground, Spring { stiffness: 1e6 });
    /// }
    /// let rotor = frame.build_rotor()?;
    /// let [forward, backward] = [Whirl::Forward, Whirl::Backward].map(|whirl| rotor.whirl(whirl).frequencies(1));
    /// assert!(forward?[0].omega > backward?[0].omega);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BuildErrors`]: all that is wrong, each with the name or the number of its part.
    pub fn build_rotor(&self) -> Result<Rotor<RotorStructure>, BuildErrors> {
        self.forward().map(Rotor::new)
    }

    /// Builds the rotor with what is damped in it: its whirls have eigenvalues, and responses.
    ///
    /// # Errors
    /// As [`build_rotor`](Frame::build_rotor).
    pub fn build_damped_rotor(&self) -> Result<Rotor<DampedRotorStructure>, BuildErrors> {
        self.damped_forward().map(Rotor::new)
    }
}

impl<E: MemberSpins<Parameter = f64>> Spinning for Framework<Line, E> {
    type BuildError = BuildErrors;

    fn turned_round(self) -> Self {
        Framework::turned_round(self)
    }
}

/// The answers of a built rotor that its whirls share.
macro_rules! answers_of_rotor {
    ($($structure:ty)*) => {$(
        impl $structure {
            /// The steady motion of an entry under unbalances at a speed [rad/s], as [`WhirlAnalysis::unbalance`](crate::WhirlAnalysis::unbalance) of
            /// sketches.
            ///
            /// # Errors
            /// As [`PlaneResponse::at`](crate::PlaneResponse::at).
            pub fn unbalance(
                &self,
                speed: f64,
                unbalances: &[(PlaneLoad<InFrame>, Complex<f64>)],
                entry: PlaneEntry<InFrame>,
            ) -> Result<Complex<f64>, MotionError> {
                steady_motion(speed, unbalances, |load, lambda| self.frequency_response(load, entry)?.at(lambda))
            }
        }

        impl Rotor<$structure> {
            /// The orbit of an entry under a load of 1 that vibrates at ω [rad/s] in the direction of v and does not turn: half of it excites each whirl.
            ///
            /// # Errors
            /// As [`PlaneResponse::at`](crate::PlaneResponse::at), of either whirl.
            pub fn orbit(
                &self,
                load: PlaneLoad<InFrame>,
                entry: PlaneEntry<InFrame>,
                omega: f64,
            ) -> Result<Orbit<f64>, MotionError> {
                Orbit::of_whirls(omega, |whirl, lambda| self.whirl(whirl).frequency_response(load, entry)?.at(lambda))
            }
        }
    )*};
}
answers_of_rotor!(RotorStructure DampedRotorStructure);
