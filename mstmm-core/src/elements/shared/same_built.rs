//! Elements that are other elements with other parameters: once both are built they are the same.

/// `$kind` builds what `$base` builds, so it has the transfer matrix and the steps of `$base`.
macro_rules! steps_as {
    ($kind:ident as $base:ident) => {
        impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for $kind<T> {
            fn transfer_matrix(built: &Self::Built, x: S) -> MatrixOf<Self, S> {
                $base::transfer_matrix(built, x)
            }
        }

        impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for $kind<T> {
            const WAVES: bool = <$base<T> as PlaneStep<S>>::WAVES;
            type Coefficients = <$base<T> as PlaneStep<S>>::Coefficients;

            #[inline(always)]
            fn coefficients(built: &Self::Built, at: &FrequencyPowers<S>) -> Self::Coefficients {
                $base::coefficients(built, at)
            }

            #[inline(always)]
            fn step<C: RootCounter<S>>(
                coefficients: &Self::Coefficients,
                input: Subspace<S>,
                counter: &mut C,
            ) -> Subspace<S> {
                $base::<T>::step(coefficients, input, counter)
            }

            #[inline(always)]
            fn root<C: RootCounter<S>>(
                coefficients: &Self::Coefficients,
                input: Subspace<S>,
                support: Support,
                counter: &mut C,
            ) -> Scaled<S> {
                $base::<T>::root(coefficients, input, support, counter)
            }
        }

        impl<T: Real, S: Oscillation<T>> BackTransfer<S> for $kind<T> {
            type BackCoefficients = <$base<T> as BackTransfer<S>>::BackCoefficients;
            const SYMMETRIC: bool = <$base<T> as BackTransfer<S>>::SYMMETRIC;

            fn reversed(built: &Self::Built) -> Self::Built {
                <$base<T> as BackTransfer<S>>::reversed(built)
            }

            fn back_coefficients(built: &Self::Built, at: &FrequencyPowers<S>) -> Self::BackCoefficients {
                $base::back_coefficients(built, at)
            }

            fn back_transfer(
                coefficients: &Self::BackCoefficients,
                input: &Subspace<S>,
                covector: Covector<S>,
            ) -> Covector<S> {
                $base::<T>::back_transfer(coefficients, input, covector)
            }
        }
    };
}
pub(crate) use steps_as;

/// The element builds what `$base` builds, so it has the units and the forms of `$base`.
macro_rules! forms_as {
    ($base:ident) => {
        fn units(built: &Self::Built, at: &FrequencyPowers<S>) -> [f64; 2] {
            <$base<T> as Energies<S>>::units(built, at)
        }

        fn mass_form(built: &Self::Built, first: &Ends<S>, second: &Ends<S>) -> S {
            $base::mass_form(built, first, second)
        }

        fn stiffness_form(built: &Self::Built, first: &Ends<S>, second: &Ends<S>) -> S {
            $base::stiffness_form(built, first, second)
        }
    };
}
pub(crate) use forms_as;
