/// Two-span beam that carries a mass on a spring (section 4.4).
#[derive(Clone, Copy, Debug)]
pub struct TwoSpans {
    /// Beam length l [m]
    pub length: f64,
    /// Bending stiffness EI of the beam [N m²]
    pub bending_stiffness: f64,
    /// Mass per length m of the beam [kg/m]
    pub mass_per_length: f64,
    /// Position x_1 of the intermediate support [m]
    pub support_position: f64,
    /// Position x_2 of the spring [m]
    pub spring_position: f64,
    /// Stiffness K_y of the spring [N/m]
    pub stiffness: f64,
    /// Mass on the spring [kg]
    pub mass: f64,
}
/// The built system of [`TwoSpans`]: evaluate it at a frequency, or search its frequencies.
///
/// # Equation
///
/// `s0` is the state behind step 0 below, `U` the transfer matrix of an element. Where paths meet, the first gives the
/// displacements, and each its forces: `F` takes the forces of a state alone. `P` takes of a state what goes on to fewer.
///
/// ```text
/// U_all z_all = 0, 7 x 7: 4 rows of the main transfer equation, geometrical equations: 3
/// z_all = [Θ(s0), Q(s0), Θ(s2), Q(s2), Y(s5), Θ(s10), Q(s10)]
/// s10 = U(beam 7) U(beam 3) U(beam 1) s0
///     + U(beam 7) U(beam 3) F s2
///     + U(beam 7) F U(spring 5) U(mass 6) s5
/// Y(s2) = Y(s1)
/// Θ(s2) = Θ(s1)
/// Y(s7) = Y(s4)
/// ```
///
/// # Steps
///
/// ```text
/// s0   = pinned                          bending
/// s1   = beam 1 (s0)                     bending
/// s2   = pinned                          bending
/// s3   = conn 2 (s1, s2)                 bending
/// s4   = beam 3 (s3)                     bending
/// s5   = free                            translation
/// s6   = mass 6 (s5)                     translation
/// s7   = spring 5 (s6)                   translation
/// s8   = conn 4 (s4, s7)                 bending
/// s9   = beam 7 (s8)                     bending
/// s10  = pinned, the root (s9)           bending
/// ```
///
/// # Paths
///
/// ```text
/// pinned -> beam 1 -> conn 2 -> beam 3 -> conn 4 -> beam 7 -> pinned, the root
/// pinned -> conn 2
/// free -> mass 6 -> spring 5 -> conn 4
/// ```
#[derive(::core::clone::Clone, ::core::fmt::Debug)]
pub struct TwoSpansSystem<T: mstmm::__private::Real = f64> {
    /// `beam 1`
    element_1: <mstmm::__private::elements::Beam<T> as mstmm::__private::Element>::Built,
    /// `beam 3`
    element_3: <mstmm::__private::elements::Beam<T> as mstmm::__private::Element>::Built,
    /// `mass 6`
    element_6: <mstmm::__private::elements::Mass<T> as mstmm::__private::Element>::Built,
    /// `spring 5`
    element_5: <mstmm::__private::elements::Spring<
        T,
    > as mstmm::__private::Element>::Built,
    /// `beam 7`
    element_7: <mstmm::__private::elements::Beam<T> as mstmm::__private::Element>::Built,
    /// The field `length`
    field_length: ::core::primitive::f64,
    /// The field `bending_stiffness`
    field_bending_stiffness: ::core::primitive::f64,
    /// The field `mass_per_length`
    field_mass_per_length: ::core::primitive::f64,
    /// The field `support_position`
    field_support_position: ::core::primitive::f64,
    /// The field `spring_position`
    field_spring_position: ::core::primitive::f64,
    /// The field `stiffness`
    field_stiffness: ::core::primitive::f64,
    /// The field `mass`
    field_mass: ::core::primitive::f64,
    parameter: ::core::marker::PhantomData<T>,
}
impl TwoSpans {
    /// Validates all parameters and builds the system.
    ///
    /// # Errors
    /// The error names the first element with a parameter out of its range, the parameter and its value.
    pub fn build(
        &self,
    ) -> ::core::result::Result<TwoSpansSystem, mstmm::__private::ParameterError> {
        self.build_as()
    }
    /// Builds the system over another scalar, such as `f32` or the double-double `DoubleDouble`.
    ///
    /// # Errors
    /// As `build`.
    pub fn build_as<T: mstmm::__private::Real>(
        &self,
    ) -> ::core::result::Result<TwoSpansSystem<T>, mstmm::__private::ParameterError> {
        let length = self.length;
        let bending_stiffness = self.bending_stiffness;
        let mass_per_length = self.mass_per_length;
        let support_position = self.support_position;
        let spring_position = self.spring_position;
        let stiffness = self.stiffness;
        let mass = self.mass;
        ::core::result::Result::Ok(TwoSpansSystem {
            element_1: mstmm::__private::build::<
                mstmm::__private::elements::Beam<T>,
            >(
                mstmm::__private::elements::Beam {
                    length: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = support_position;
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
            element_3: mstmm::__private::build::<
                mstmm::__private::elements::Beam<T>,
            >(
                mstmm::__private::elements::Beam {
                    length: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = spring_position
                            - support_position;
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
                "beam 3",
            )?,
            element_6: mstmm::__private::build::<
                mstmm::__private::elements::Mass<T>,
            >(
                mstmm::__private::elements::Mass {
                    mass: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = mass;
                        number
                    }),
                },
                "mass 6",
            )?,
            element_5: mstmm::__private::build::<
                mstmm::__private::elements::Spring<T>,
            >(
                mstmm::__private::elements::Spring {
                    stiffness: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = stiffness;
                        number
                    }),
                },
                "spring 5",
            )?,
            element_7: mstmm::__private::build::<
                mstmm::__private::elements::Beam<T>,
            >(
                mstmm::__private::elements::Beam {
                    length: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = length - spring_position;
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
                "beam 7",
            )?,
            field_length: self.length,
            field_bending_stiffness: self.bending_stiffness,
            field_mass_per_length: self.mass_per_length,
            field_support_position: self.support_position,
            field_spring_position: self.spring_position,
            field_stiffness: self.stiffness,
            field_mass: self.mass,
            parameter: ::core::marker::PhantomData,
        })
    }
}
#[automatically_derived]
impl<T: mstmm::__private::Real> mstmm::__private::System for TwoSpansSystem<T> {
    type Parameter = T;
    fn estimates(&self) -> mstmm::__private::FrequencyEstimates {
        let mut estimates = ::core::default::Default::default();
        <mstmm::__private::elements::Beam<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_1, &mut estimates);
        <mstmm::__private::elements::Beam<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_3, &mut estimates);
        <mstmm::__private::elements::Mass<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_6, &mut estimates);
        <mstmm::__private::elements::Spring<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_5, &mut estimates);
        <mstmm::__private::elements::Beam<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_7, &mut estimates);
        estimates
    }
}
/// The labels of the sketch: elements and connections, as results about motions take them.
#[allow(dead_code, non_upper_case_globals)]
impl TwoSpans {
    /// `beam 1`
    pub const beam_1: mstmm::__private::Label<
        TwoSpans,
        mstmm::__private::elements::Beam<f64>,
    > = mstmm::__private::Label::new(1usize, 0usize);
    /// `conn 2`
    pub const conn_2: mstmm::__private::Point<TwoSpans> = mstmm::__private::Point::connection(
        3usize,
    );
    /// `beam 3`
    pub const beam_3: mstmm::__private::Label<
        TwoSpans,
        mstmm::__private::elements::Beam<f64>,
    > = mstmm::__private::Label::new(4usize, 3usize);
    /// `mass 6`
    pub const mass_6: mstmm::__private::Label<
        TwoSpans,
        mstmm::__private::elements::Mass<f64>,
    > = mstmm::__private::Label::new(6usize, 5usize);
    /// `spring 5`
    pub const spring_5: mstmm::__private::Label<
        TwoSpans,
        mstmm::__private::elements::Spring<f64>,
    > = mstmm::__private::Label::new(7usize, 6usize);
    /// `conn 4`
    pub const conn_4: mstmm::__private::Point<TwoSpans> = mstmm::__private::Point::connection(
        8usize,
    );
    /// `beam 7`
    pub const beam_7: mstmm::__private::Label<
        TwoSpans,
        mstmm::__private::elements::Beam<f64>,
    > = mstmm::__private::Label::new(9usize, 8usize);
}
#[automatically_derived]
impl<T: mstmm::__private::Real> mstmm::__private::Fields for TwoSpansSystem<T> {
    const NAMES: &'static [&'static ::core::primitive::str] = &[
        "length",
        "bending_stiffness",
        "mass_per_length",
        "support_position",
        "spring_position",
        "stiffness",
        "mass",
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
impl<T, S> mstmm::__private::Chain<S> for TwoSpansSystem<T>
where
    T: mstmm::__private::Real,
    S: mstmm::__private::Frequency<T>,
    mstmm::__private::elements::Beam<
        T,
    >: mstmm::__private::Energies<S, Gradient = mstmm::__private::elements::Beam<S>>,
    mstmm::__private::elements::Mass<
        T,
    >: mstmm::__private::Energies<S, Gradient = mstmm::__private::elements::Mass<S>>,
    mstmm::__private::elements::Spring<
        T,
    >: mstmm::__private::Energies<S, Gradient = mstmm::__private::elements::Spring<S>>,
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
        let support_position = chain.variable(self.field_support_position);
        let spring_position = chain.variable(self.field_spring_position);
        let stiffness = chain.variable(self.field_stiffness);
        let mass = chain.variable(self.field_mass);
        let values = (support_position, bending_stiffness, mass_per_length);
        for step in [1usize] {
            let gradient = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_1, &ends(step));
            chain.add(gradient.length, values.0);
            chain.add(gradient.bending_stiffness, values.1);
            chain.add(gradient.mass_per_length, values.2);
        }
        let values = (
            spring_position - support_position,
            bending_stiffness,
            mass_per_length,
        );
        for step in [4usize] {
            let gradient = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_3, &ends(step));
            chain.add(gradient.length, values.0);
            chain.add(gradient.bending_stiffness, values.1);
            chain.add(gradient.mass_per_length, values.2);
        }
        let values = (mass,);
        for step in [6usize] {
            let gradient = <mstmm::__private::elements::Mass<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_6, &ends(step));
            chain.add(gradient.mass, values.0);
        }
        let values = (stiffness,);
        for step in [7usize] {
            let gradient = <mstmm::__private::elements::Spring<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_5, &ends(step));
            chain.add(gradient.stiffness, values.0);
        }
        let values = (length - spring_position, bending_stiffness, mass_per_length);
        for step in [9usize] {
            let gradient = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_7, &ends(step));
            chain.add(gradient.length, values.0);
            chain.add(gradient.bending_stiffness, values.1);
            chain.add(gradient.mass_per_length, values.2);
        }
        chain.finish()
    }
}
const _: () = {
    const LAYOUT: mstmm::__private::Scheme<'static> = const {
        &mstmm::__private::Layout::new([
            mstmm::__private::Step::Tip(mstmm::__private::Support::Pinned),
            mstmm::__private::Step::Element(
                0usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Beam<f64>>(),
            ),
            mstmm::__private::Step::Tip(mstmm::__private::Support::Pinned),
            mstmm::__private::Step::Connection(&[1usize, 2usize]),
            mstmm::__private::Step::Element(
                3usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Beam<f64>>(),
            ),
            mstmm::__private::Step::Tip(mstmm::__private::Support::Free),
            mstmm::__private::Step::Element(
                5usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Mass<f64>>(),
            ),
            mstmm::__private::Step::Element(
                6usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Spring<f64>>(),
            ),
            mstmm::__private::Step::Connection(&[4usize, 7usize]),
            mstmm::__private::Step::Element(
                8usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Beam<f64>>(),
            ),
            mstmm::__private::Step::Root(9usize, mstmm::__private::Support::Pinned),
        ])
    }
        .scheme();
    const _: () = LAYOUT.check_support(0usize);
    const _: () = LAYOUT.check_arrow(1usize);
    const _: () = LAYOUT.check_support(2usize);
    const _: () = LAYOUT.check_connection(3usize);
    const _: () = LAYOUT.check_arrow(4usize);
    const _: () = LAYOUT.check_support(5usize);
    const _: () = LAYOUT.check_arrow(6usize);
    const _: () = LAYOUT.check_arrow(7usize);
    const _: () = LAYOUT.check_connection(8usize);
    const _: () = LAYOUT.check_arrow(9usize);
    const _: () = LAYOUT.check_support(10usize);
    impl TwoSpansSystem {
        /// Width of the reduced overall matrix: the number of unknowns at the boundaries.
        pub const N: usize = 7;
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Evaluate<S> for TwoSpansSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::TransferMatrix<S>,
        mstmm::__private::elements::Mass<T>: mstmm::__private::TransferMatrix<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::TransferMatrix<S>,
    {
        type Matrix = mstmm::__private::SMatrix<S, 7, 7>;
        fn overall_matrix(&self, x: S) -> Self::Matrix {
            let u_1 = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_1, x);
            let u_3 = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_3, x);
            let u_6 = <mstmm::__private::elements::Mass<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_6, x);
            let u_5 = <mstmm::__private::elements::Spring<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_5, x);
            let u_7 = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_7, x);
            let mut equation = mstmm::__private::Assembly::new(LAYOUT);
            equation.element::<mstmm::__private::elements::Beam<T>>(1usize, &u_1);
            equation.connection(3usize);
            equation.element::<mstmm::__private::elements::Beam<T>>(4usize, &u_3);
            equation.element::<mstmm::__private::elements::Mass<T>>(6usize, &u_6);
            equation.element::<mstmm::__private::elements::Spring<T>>(7usize, &u_5);
            equation.connection(8usize);
            equation.element::<mstmm::__private::elements::Beam<T>>(9usize, &u_7);
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
                mstmm::__private::elements::Beam<T>,
                S,
            >(determinant, &self.element_3, x);
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::Mass<T>,
                S,
            >(determinant, &self.element_6, x);
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::Spring<T>,
                S,
            >(determinant, &self.element_5, x);
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::Beam<T>,
                S,
            >(determinant, &self.element_7, x);
            determinant
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Characteristic<S> for TwoSpansSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Mass<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::PlaneStep<S>,
    {
        #[inline]
        fn pass<C: mstmm::__private::RootCounter<S>>(
            &self,
            x: S,
            counter: &mut C,
        ) -> mstmm::__private::Scaled<S> {
            const STEPS: usize = 11usize;
            let at = mstmm::__private::FrequencyPowers::new(
                x,
                false
                    || <mstmm::__private::elements::Beam<
                        T,
                    > as mstmm::__private::PlaneStep<S>>::WAVES
                    || <mstmm::__private::elements::Mass<
                        T,
                    > as mstmm::__private::PlaneStep<S>>::WAVES
                    || <mstmm::__private::elements::Spring<
                        T,
                    > as mstmm::__private::PlaneStep<S>>::WAVES,
            );
            let k_1 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Beam<T>,
                S,
                STEPS,
            >(&self.element_1, &at);
            let k_3 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Beam<T>,
                S,
                STEPS,
            >(&self.element_3, &at);
            let k_6 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Mass<T>,
                S,
                STEPS,
            >(&self.element_6, &at);
            let k_5 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Spring<T>,
                S,
                STEPS,
            >(&self.element_5, &at);
            let k_7 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Beam<T>,
                S,
                STEPS,
            >(&self.element_7, &at);
            let s0 = mstmm::__private::Subspace::Tip(
                mstmm::__private::Support::Pinned,
                const { LAYOUT.space(0usize) },
            );
            let s1 = mstmm::__private::step::<
                mstmm::__private::elements::Beam<T>,
                S,
                C,
                STEPS,
            >(&k_1, s0, counter);
            let s3 = s1;
            let s3 = mstmm::__private::widened(s3, const { LAYOUT.output(3usize) });
            let s3 = mstmm::__private::held(s3, mstmm::__private::Support::Pinned);
            let s3 = mstmm::__private::narrowed(
                s3,
                const { LAYOUT.output(3usize) },
                counter,
            );
            let s4 = mstmm::__private::step::<
                mstmm::__private::elements::Beam<T>,
                S,
                C,
                STEPS,
            >(&k_3, s3, counter);
            let s5 = mstmm::__private::Subspace::Tip(
                mstmm::__private::Support::Free,
                const { LAYOUT.space(5usize) },
            );
            let s6 = mstmm::__private::step::<
                mstmm::__private::elements::Mass<T>,
                S,
                C,
                STEPS,
            >(&k_6, s5, counter);
            let s7 = mstmm::__private::step::<
                mstmm::__private::elements::Spring<T>,
                S,
                C,
                STEPS,
            >(&k_5, s6, counter);
            let s8 = s4;
            let s8 = mstmm::__private::join::<S, C, true, STEPS>(s8, s7, counter);
            let s8 = mstmm::__private::widened(s8, const { LAYOUT.output(8usize) });
            let s8 = mstmm::__private::narrowed(
                s8,
                const { LAYOUT.output(8usize) },
                counter,
            );
            mstmm::__private::root::<
                mstmm::__private::elements::Beam<T>,
                S,
                C,
                STEPS,
            >(&k_7, s8, mstmm::__private::Support::Pinned, counter)
        }
    }
    #[automatically_derived]
    impl<T: mstmm::__private::Real> mstmm::__private::Planned for TwoSpansSystem<T> {
        type Model = TwoSpans;
        type PerStep<C: ::core::marker::Copy + ::core::fmt::Debug> = [C; 11usize];
        fn per_step<C: ::core::marker::Copy + ::core::fmt::Debug>(
            value: C,
        ) -> [C; 11usize] {
            [value; 11usize]
        }
        fn scheme() -> mstmm::__private::Scheme<'static> {
            LAYOUT
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Tree<S> for TwoSpansSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::Mass<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::Energies<S>,
    {
        type Evaluated = (
            <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
            <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
            <mstmm::__private::elements::Mass<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
            <mstmm::__private::elements::Spring<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
            <mstmm::__private::elements::Beam<
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
                    || <mstmm::__private::elements::Mass<
                        T,
                    > as mstmm::__private::PlaneStep<S>>::WAVES
                    || <mstmm::__private::elements::Spring<
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
                <mstmm::__private::elements::Beam<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_3, at),
                <mstmm::__private::elements::Mass<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_6, at),
                <mstmm::__private::elements::Spring<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_5, at),
                <mstmm::__private::elements::Beam<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_7, at),
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
                    4usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Beam<T>,
                            >(&self.element_3)
                    }
                    6usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Mass<T>,
                            >(&self.element_6)
                    }
                    7usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Spring<T>,
                            >(&self.element_5)
                    }
                    9usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Beam<T>,
                            >(&self.element_7)
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
                    4usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Beam<T>,
                            >(&self.element_3, &evaluated.1)
                    }
                    6usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Mass<T>,
                            >(&self.element_6, &evaluated.2)
                    }
                    7usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Spring<T>,
                            >(&self.element_5, &evaluated.3)
                    }
                    9usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Beam<T>,
                            >(&self.element_7, &evaluated.4)
                    }
                    _ => return ::core::option::Option::None,
                },
            )
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::TreeInBlocks<S> for TwoSpansSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::Mass<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::Beam<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Mass<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Spring<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Beam<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
        mstmm::__private::elements::Mass<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
        mstmm::__private::elements::Spring<
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
                4usize => {
                    visitor
                        .element::<mstmm::__private::elements::Beam<T>>(&self.element_3)
                }
                6usize => {
                    visitor
                        .element::<mstmm::__private::elements::Mass<T>>(&self.element_6)
                }
                7usize => {
                    visitor
                        .element::<
                            mstmm::__private::elements::Spring<T>,
                        >(&self.element_5)
                }
                9usize => {
                    visitor
                        .element::<mstmm::__private::elements::Beam<T>>(&self.element_7)
                }
                _ => {}
            }
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Walk<S> for TwoSpansSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Mass<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Beam<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Mass<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Spring<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Beam<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
        mstmm::__private::elements::Mass<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
        mstmm::__private::elements::Spring<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
    {
        fn walk<C: mstmm::__private::Walker<S>>(&self, walker: &mut C) {
            walker
                .tip(mstmm::__private::Support::Pinned, const { LAYOUT.space(0usize) });
            walker.element::<mstmm::__private::elements::Beam<T>>(&self.element_1);
            walker
                .tip(mstmm::__private::Support::Pinned, const { LAYOUT.space(2usize) });
            walker.connection(&[1, 0], const { LAYOUT.output(3usize) });
            walker.element::<mstmm::__private::elements::Beam<T>>(&self.element_3);
            walker.tip(mstmm::__private::Support::Free, const { LAYOUT.space(5usize) });
            walker.element::<mstmm::__private::elements::Mass<T>>(&self.element_6);
            walker.element::<mstmm::__private::elements::Spring<T>>(&self.element_5);
            walker.connection(&[1, 0], const { LAYOUT.output(8usize) });
            walker.element::<mstmm::__private::elements::Beam<T>>(&self.element_7);
            walker.root(mstmm::__private::Support::Pinned);
        }
    }
};
