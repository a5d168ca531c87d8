//! What beams are by what is built of them: with damping and without, a step of bending and a motion have the same forms.

/// Transfer matrix and steps of a beam at the frequencies of a trait.
macro_rules! steps_of_built {
    ($beam:ident at $frequency:ident) => {
        impl<T: Parameter, S: $frequency<T> + Single> TransferMatrix<S> for $beam<T> {
            fn transfer_matrix(built: &Self::Built, x: S) -> MatrixOf<Self, S> {
                built.transfer_matrix(x)
            }
        }

        impl<T: Parameter, S: $frequency<T>> PlaneStep<S> for $beam<T> {
            type Coefficients = GeneralCompound<S>;

            fn coefficients(built: &Self::Built, at: &FrequencyPowers<S>) -> GeneralCompound<S> {
                built.compound(at)
            }

            fn step<C: RootCounter<S>>(
                compound: &GeneralCompound<S>,
                input: Subspace<S>,
                counter: &mut C,
            ) -> Subspace<S> {
                compound.step(input, counter)
            }

            fn root<C: RootCounter<S>>(
                compound: &GeneralCompound<S>,
                input: Subspace<S>,
                support: Support,
                counter: &mut C,
            ) -> Scaled<S> {
                compound.root(input, support, counter)
            }
        }

        impl<T: Real, S: $frequency<T> + Oscillation<T>> BackTransfer<S> for $beam<T> {
            type BackCoefficients = BackThrough<S>;
            const SYMMETRIC: bool = true;

            fn reversed(built: &Self::Built) -> Self::Built {
                *built
            }

            fn back_coefficients(built: &Self::Built, at: &FrequencyPowers<S>) -> BackThrough<S> {
                built.back_through(at)
            }

            fn back_transfer(through: &BackThrough<S>, _input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
                through.back_transfer(covector)
            }
        }
    };
}
pub(super) use steps_of_built;

/// Units, forms and states of the energies of a beam.
macro_rules! energies_of_built {
    () => {
        fn units(built: &Self::Built, at: &FrequencyPowers<S>) -> [f64; 2] {
            built.motion(at.x).units()
        }

        fn mass_form(built: &Self::Built, first: &Ends<S>, second: &Ends<S>) -> S {
            built.forms(first, second).mass
        }

        fn stiffness_form(built: &Self::Built, first: &Ends<S>, second: &Ends<S>) -> S {
            built.forms(first, second).stiffness
        }

        fn inside(built: &Self::Built, x: S) -> Option<Inside> {
            Some(built.motion(x).interior())
        }

        fn state_at(built: &Self::Built, ends: &Ends<S>, distance: f64) -> State<S> {
            built.motion(ends.x).state_at(ends, T::from_f64(distance))
        }

        fn load_work(built: &Self::Built, ends: &Ends<S>) -> Option<S> {
            Some(built.motion(ends.x).load_work(ends))
        }

        fn mass_per_length(built: &Self::Built) -> S {
            S::from_parameter(built.mass_per_length())
        }
    };
}
pub(super) use energies_of_built;

/// The chart and the motion of a beam between two points of a line, at the frequencies of a trait.
macro_rules! members_of_built {
    ($beam:ident at $frequency:ident) => {
        impl<T: Parameter, S: $frequency<T> + ChartScalar> ChartedAcross<S> for $beam<T> {
            fn chart_across(built: &Self::Built, at: &FrequencyPowers<S>, length: S, along: Option<f64>) -> Chart<S> {
                built.chart(at, length, along)
            }
        }

        impl<T: Parameter, S: $frequency<T> + ChartScalar> Charted<S> for $beam<T> {
            fn chart(built: &Self::Built, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
                built.chart(at, length, None)
            }
        }

        impl<T: Real, S: $frequency<T> + Oscillation<T>> MemberMotion<S> for $beam<T> {
            fn forms(built: &Self::Built, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
                built.forms(&first.bending(), &second.bending())
            }

            fn inside(built: &Self::Built, x: S) -> Option<Inside> {
                Some(built.motion(x).interior())
            }

            fn motion_at(built: &Self::Built, motion: &MemberEnds<S>, distance: f64) -> EndMotion<S> {
                EndMotion::bent(built.motion(motion.x).state_at(&motion.bending(), T::from_f64(distance)))
            }

            fn deflection(built: &Self::Built, motion: &MemberEnds<S>) -> Option<Deflection<S>> {
                Some(built.motion(motion.x).deflection(&motion.bending()))
            }

            fn load_work(built: &Self::Built, motion: &MemberEnds<S>) -> Option<[S; 2]> {
                Some([S::zero(), built.motion(motion.x).load_work(&motion.bending())])
            }

            fn mass_per_length(built: &Self::Built) -> S {
                S::from_parameter(built.mass_per_length())
            }

            fn motion_under_load(
                built: &Self::Built,
                motion: &MemberEnds<S>,
                [_, load]: [S; 2],
                distance: f64,
            ) -> EndMotion<S> {
                EndMotion::bent(built.motion(motion.x).state_under(&motion.bending(), load, T::from_f64(distance)))
            }
        }
    };
}
pub(super) use members_of_built;
