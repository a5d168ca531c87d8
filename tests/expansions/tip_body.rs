/// Cantilever with an eccentric rigid body at its tip (section 4.1).
#[derive(Clone, Copy, Debug)]
pub struct TipBody {
    /// Beam length l [m]
    pub length: f64,
    /// Bending stiffness EI of the beam [N m²]
    pub bending_stiffness: f64,
    /// Mass per length m of the beam [kg/m]
    pub mass_per_length: f64,
    /// Mass of the body [kg]
    pub mass: f64,
    /// Moment of inertia of the body about its mass centre, J_c [kg m²]
    pub inertia: f64,
    /// Distance e of the body's mass centre from the end of the beam [m]
    pub eccentricity: f64,
    /// Distance d of the body's free end from the end of the beam [m]
    pub depth: f64,
}
/// The built system of [`TipBody`]: evaluate it at a frequency, or search its frequencies.
///
/// # Equation
///
/// `s0` is the state behind step 0 below, `U` the transfer matrix of an element. Where paths meet, the first gives the
/// displacements, and each its forces: `F` takes the forces of a state alone. `P` takes of a state what goes on to fewer.
///
/// ```text
/// U_all z_all = 0, 4 x 4: 4 rows of the main transfer equation, geometrical equations: 0
/// z_all = [M(s0), Q(s0), Y(s3), Θ(s3)]
/// s3 = U(body 2) U(beam 1) s0
/// ```
///
/// # Steps
///
/// ```text
/// s0   = fixed                           bending
/// s1   = beam 1 (s0)                     bending
/// s2   = body 2 (s1)                     bending
/// s3   = free, the root (s2)             bending
/// ```
///
/// # Paths
///
/// ```text
/// fixed -> beam 1 -> body 2 -> free, the root
/// ```
#[derive(::core::clone::Clone, ::core::fmt::Debug)]
pub struct TipBodySystem<T: mstmm::__private::Real = f64> {
    /// `beam 1`
    element_1: <mstmm::__private::elements::Beam<T> as mstmm::__private::Element>::Built,
    /// `body 2`
    element_2: <mstmm::__private::elements::Body<T> as mstmm::__private::Element>::Built,
    /// The field `length`
    field_length: ::core::primitive::f64,
    /// The field `bending_stiffness`
    field_bending_stiffness: ::core::primitive::f64,
    /// The field `mass_per_length`
    field_mass_per_length: ::core::primitive::f64,
    /// The field `mass`
    field_mass: ::core::primitive::f64,
    /// The field `inertia`
    field_inertia: ::core::primitive::f64,
    /// The field `eccentricity`
    field_eccentricity: ::core::primitive::f64,
    /// The field `depth`
    field_depth: ::core::primitive::f64,
    parameter: ::core::marker::PhantomData<T>,
}
impl TipBody {
    /// Validates all parameters and builds the system.
    ///
    /// # Errors
    /// The error names the first element with a parameter out of its range, the parameter and its value.
    pub fn build(
        &self,
    ) -> ::core::result::Result<TipBodySystem, mstmm::__private::ParameterError> {
        self.build_as()
    }
    /// Builds the system over another scalar, such as `f32` or the double-double `DoubleDouble`.
    ///
    /// # Errors
    /// As `build`.
    pub fn build_as<T: mstmm::__private::Real>(
        &self,
    ) -> ::core::result::Result<TipBodySystem<T>, mstmm::__private::ParameterError> {
        let length = self.length;
        let bending_stiffness = self.bending_stiffness;
        let mass_per_length = self.mass_per_length;
        let mass = self.mass;
        let inertia = self.inertia;
        let eccentricity = self.eccentricity;
        let depth = self.depth;
        let inertia_about_input = inertia + mass * eccentricity * eccentricity;
        ::core::result::Result::Ok(TipBodySystem {
            element_1: mstmm::__private::build::<
                mstmm::__private::elements::Beam<T>,
            >(
                mstmm::__private::elements::Beam {
                    length: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = length;
                        number
                    }),
                    bending_stiffness: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = bending_stiffness;
                        number
                    }),
                    mass_per_length: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = mass_per_length;
                        number
                    }),
                },
                "beam 1",
            )?,
            element_2: mstmm::__private::build::<
                mstmm::__private::elements::Body<T>,
            >(
                mstmm::__private::elements::Body {
                    mass: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = mass;
                        number
                    }),
                    inertia: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = inertia_about_input;
                        number
                    }),
                    output_x: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = depth;
                        number
                    }),
                    centre_x: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = eccentricity;
                        number
                    }),
                },
                "body 2",
            )?,
            field_length: self.length,
            field_bending_stiffness: self.bending_stiffness,
            field_mass_per_length: self.mass_per_length,
            field_mass: self.mass,
            field_inertia: self.inertia,
            field_eccentricity: self.eccentricity,
            field_depth: self.depth,
            parameter: ::core::marker::PhantomData,
        })
    }
}
#[automatically_derived]
impl<T: mstmm::__private::Real> mstmm::__private::System for TipBodySystem<T> {
    type Parameter = T;
    fn estimates(&self) -> mstmm::__private::FrequencyEstimates {
        let mut estimates = ::core::default::Default::default();
        <mstmm::__private::elements::Beam<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_1, &mut estimates);
        <mstmm::__private::elements::Body<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_2, &mut estimates);
        estimates
    }
}
/// The labels of the sketch: elements and connections, as results about motions take them.
#[allow(dead_code, non_upper_case_globals)]
impl TipBody {
    /// `beam 1`
    pub const beam_1: mstmm::__private::Label<
        TipBody,
        mstmm::__private::elements::Beam<f64>,
    > = mstmm::__private::Label::new(1usize, 0usize);
    /// `body 2`
    pub const body_2: mstmm::__private::Label<
        TipBody,
        mstmm::__private::elements::Body<f64>,
    > = mstmm::__private::Label::new(2usize, 1usize);
}
#[automatically_derived]
impl<T: mstmm::__private::Real> mstmm::__private::Fields for TipBodySystem<T> {
    const NAMES: &'static [&'static ::core::primitive::str] = &[
        "length",
        "bending_stiffness",
        "mass_per_length",
        "mass",
        "inertia",
        "eccentricity",
        "depth",
    ];
    type PerField<V: ::core::marker::Copy + ::core::fmt::Debug> = [V; <[()]>::len(
        &[(), (), (), (), (), (), ()],
    )];
    fn per_field<V: ::core::marker::Copy + ::core::fmt::Debug>(
        value: V,
    ) -> Self::PerField<V> {
        [value; _]
    }
}
#[automatically_derived]
impl<T, S> mstmm::__private::Chain<S> for TipBodySystem<T>
where
    T: mstmm::__private::Real,
    S: mstmm::__private::Frequency<T>,
    mstmm::__private::elements::Beam<
        T,
    >: mstmm::__private::Energies<S, Gradient = mstmm::__private::elements::Beam<S>>,
    mstmm::__private::elements::Body<
        T,
    >: mstmm::__private::Energies<S, Gradient = mstmm::__private::elements::Body<S>>,
{
    fn chain(
        &self,
        ends: impl ::core::ops::Fn(::core::primitive::usize) -> mstmm::__private::Ends<S>,
    ) -> Self::PerField<S> {
        let zeros = <Self as mstmm::__private::Fields>::per_field(
            mstmm::__private::Scalar::from_f64(0.0),
        );
        let mut chain = mstmm::__private::ChainRule::new(zeros);
        let length = chain.variable(self.field_length);
        let bending_stiffness = chain.variable(self.field_bending_stiffness);
        let mass_per_length = chain.variable(self.field_mass_per_length);
        let mass = chain.variable(self.field_mass);
        let inertia = chain.variable(self.field_inertia);
        let eccentricity = chain.variable(self.field_eccentricity);
        let depth = chain.variable(self.field_depth);
        let inertia_about_input = inertia + mass * eccentricity * eccentricity;
        let values = (length, bending_stiffness, mass_per_length);
        for step in [1usize] {
            let gradient = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_1, &ends(step));
            chain.add(gradient.length, values.0);
            chain.add(gradient.bending_stiffness, values.1);
            chain.add(gradient.mass_per_length, values.2);
        }
        let values = (mass, inertia_about_input, depth, eccentricity);
        for step in [2usize] {
            let gradient = <mstmm::__private::elements::Body<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_2, &ends(step));
            chain.add(gradient.mass, values.0);
            chain.add(gradient.inertia, values.1);
            chain.add(gradient.output_x, values.2);
            chain.add(gradient.centre_x, values.3);
        }
        chain.finish()
    }
}
const _: () = {
    const LAYOUT: mstmm::__private::Scheme<'static> = const {
        &mstmm::__private::Layout::new([
            mstmm::__private::Step::Tip(mstmm::__private::Support::Fixed),
            mstmm::__private::Step::Element(
                0usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Beam<f64>>(),
            ),
            mstmm::__private::Step::Element(
                1usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Body<f64>>(),
            ),
            mstmm::__private::Step::Root(2usize, mstmm::__private::Support::Free),
        ])
    }
        .scheme();
    const _: () = LAYOUT.check_support(0usize);
    const _: () = LAYOUT.check_arrow(1usize);
    const _: () = LAYOUT.check_arrow(2usize);
    const _: () = LAYOUT.check_support(3usize);
    impl TipBodySystem {
        /// Width of the reduced overall matrix: the number of unknowns at the boundaries.
        pub const N: usize = 4;
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Evaluate<S> for TipBodySystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::TransferMatrix<S>,
        mstmm::__private::elements::Body<T>: mstmm::__private::TransferMatrix<S>,
    {
        type Matrix = mstmm::__private::SMatrix<S, 4, 4>;
        fn overall_matrix(&self, x: S) -> Self::Matrix {
            let u_1 = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_1, x);
            let u_2 = <mstmm::__private::elements::Body<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_2, x);
            let mut equation = mstmm::__private::Assembly::new(LAYOUT);
            equation.element::<mstmm::__private::elements::Beam<T>>(1usize, &u_1);
            equation.element::<mstmm::__private::elements::Body<T>>(2usize, &u_2);
            equation.finish()
        }
        fn overall_determinant(&self, x: S) -> mstmm::__private::Scaled<S> {
            let determinant = mstmm::__private::determinant(
                mstmm::__private::Evaluate::overall_matrix(self, x),
            );
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::Beam<T>,
                S,
            >(determinant, &self.element_1, x);
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::Body<T>,
                S,
            >(determinant, &self.element_2, x);
            determinant
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Characteristic<S> for TipBodySystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Body<T>: mstmm::__private::PlaneStep<S>,
    {
        #[inline]
        fn pass<C: mstmm::__private::RootCounter<S>>(
            &self,
            x: S,
            counter: &mut C,
        ) -> mstmm::__private::Scaled<S> {
            const STEPS: usize = 4usize;
            let at = mstmm::__private::FrequencyPowers::new(
                x,
                false
                    || <mstmm::__private::elements::Beam<
                        T,
                    > as mstmm::__private::PlaneStep<S>>::WAVES
                    || <mstmm::__private::elements::Body<
                        T,
                    > as mstmm::__private::PlaneStep<S>>::WAVES,
            );
            let k_1 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Beam<T>,
                S,
                STEPS,
            >(&self.element_1, &at);
            let k_2 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Body<T>,
                S,
                STEPS,
            >(&self.element_2, &at);
            let s0 = mstmm::__private::Subspace::Tip(
                mstmm::__private::Support::Fixed,
                const { LAYOUT.space(0usize) },
            );
            let s1 = mstmm::__private::step::<
                mstmm::__private::elements::Beam<T>,
                S,
                C,
                STEPS,
            >(&k_1, s0, counter);
            mstmm::__private::root::<
                mstmm::__private::elements::Body<T>,
                S,
                C,
                STEPS,
            >(&k_2, s1, mstmm::__private::Support::Free, counter)
        }
    }
    #[automatically_derived]
    impl<T: mstmm::__private::Real> mstmm::__private::Planned for TipBodySystem<T> {
        type Model = TipBody;
        type PerStep<C: ::core::marker::Copy + ::core::fmt::Debug> = [C; 4usize];
        fn per_step<C: ::core::marker::Copy + ::core::fmt::Debug>(
            value: C,
        ) -> [C; 4usize] {
            [value; 4usize]
        }
        fn scheme() -> mstmm::__private::Scheme<'static> {
            LAYOUT
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Tree<S> for TipBodySystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::Body<T>: mstmm::__private::Energies<S>,
    {
        type Evaluated = (
            <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
            <mstmm::__private::elements::Body<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
        );
        fn at(x: S) -> mstmm::__private::FrequencyPowers<S> {
            mstmm::__private::FrequencyPowers::new(
                x,
                false
                    || <mstmm::__private::elements::Beam<
                        T,
                    > as mstmm::__private::PlaneStep<S>>::WAVES
                    || <mstmm::__private::elements::Body<
                        T,
                    > as mstmm::__private::PlaneStep<S>>::WAVES,
            )
        }
        fn evaluate(
            &self,
            at: &mstmm::__private::FrequencyPowers<S>,
        ) -> Self::Evaluated {
            (
                <mstmm::__private::elements::Beam<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_1, at),
                <mstmm::__private::elements::Body<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_2, at),
            )
        }
        fn visit<C: mstmm::__private::Visit<S>>(
            &self,
            step: usize,
            visitor: C,
        ) -> ::core::option::Option<C::Output> {
            ::core::option::Option::Some(
                match step {
                    1usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Beam<T>,
                            >(&self.element_1)
                    }
                    2usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Body<T>,
                            >(&self.element_2)
                    }
                    _ => return ::core::option::Option::None,
                },
            )
        }
        fn visit_at<C: mstmm::__private::VisitAt<S>>(
            &self,
            evaluated: &Self::Evaluated,
            step: usize,
            visitor: C,
        ) -> ::core::option::Option<C::Output> {
            ::core::option::Option::Some(
                match step {
                    1usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Beam<T>,
                            >(&self.element_1, &evaluated.0)
                    }
                    2usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Body<T>,
                            >(&self.element_2, &evaluated.1)
                    }
                    _ => return ::core::option::Option::None,
                },
            )
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::TreeInBlocks<S> for TipBodySystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::Body<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::Beam<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Body<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Beam<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
        mstmm::__private::elements::Body<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
    {
        fn visit_in_block<C: mstmm::__private::VisitInBlock<S>>(
            &self,
            step: usize,
            visitor: C,
        ) {
            match step {
                1usize => {
                    visitor
                        .element::<mstmm::__private::elements::Beam<T>>(&self.element_1)
                }
                2usize => {
                    visitor
                        .element::<mstmm::__private::elements::Body<T>>(&self.element_2)
                }
                _ => {}
            }
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Walk<S> for TipBodySystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Body<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Beam<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Body<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Beam<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
        mstmm::__private::elements::Body<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
    {
        fn walk<C: mstmm::__private::Walker<S>>(&self, walker: &mut C) {
            walker.tip(mstmm::__private::Support::Fixed, const { LAYOUT.space(0usize) });
            walker.element::<mstmm::__private::elements::Beam<T>>(&self.element_1);
            walker.element::<mstmm::__private::elements::Body<T>>(&self.element_2);
            walker.root(mstmm::__private::Support::Free);
        }
    }
};
