/// Free-free beam whose ends are restrained by elastic hinges (section 4.2).
#[derive(Clone, Copy, Debug)]
pub struct RestrainedBeam {
    /// Beam length l [m]
    pub length: f64,
    /// Bending stiffness EI of the beam [N m²]
    pub bending_stiffness: f64,
    /// Mass per length m of the beam [kg/m]
    pub mass_per_length: f64,
    /// Translational stiffness K_y1 at the left end [N/m]
    pub left_stiffness: f64,
    /// Torsional stiffness K'_z1 at the left end [N m/rad]
    pub left_torsion: f64,
    /// Translational stiffness K_y2 at the right end [N/m]
    pub right_stiffness: f64,
    /// Torsional stiffness K'_z2 at the right end [N m/rad]
    pub right_torsion: f64,
}
/// The built system of [`RestrainedBeam`]: evaluate it at a frequency, or search its frequencies.
///
/// # Equation
///
/// `s0` is the state behind step 0 below, `U` the transfer matrix of an element. Where paths meet, the first gives the
/// displacements, and each its forces: `F` takes the forces of a state alone. `P` takes of a state what goes on to fewer.
///
/// ```text
/// U_all z_all = 0, 8 x 8: 4 rows of the main transfer equation, geometrical equations: 4
/// z_all = [Y(s0), Θ(s0), M(s1), Q(s1), M(s5), Q(s5), Y(s8), Θ(s8)]
/// s8 = U(beam 3) s0
///     + U(beam 3) F U(elastic_hinge 1) s1
///     + F U(elastic_hinge 5) s5
/// Y(s2) = Y(s0)
/// Θ(s2) = Θ(s0)
/// Y(s6) = Y(s4)
/// Θ(s6) = Θ(s4)
/// ```
///
/// # Steps
///
/// ```text
/// s0   = free                            bending
/// s1   = fixed                           bending
/// s2   = elastic_hinge 1 (s1)            bending
/// s3   = conn 2 (s0, s2)                 bending
/// s4   = beam 3 (s3)                     bending
/// s5   = fixed                           bending
/// s6   = elastic_hinge 5 (s5)            bending
/// s7   = conn 4 (s4, s6)                 bending
/// s8   = free, the root (s7)             bending
/// ```
///
/// # Paths
///
/// ```text
/// free -> conn 2 -> beam 3 -> conn 4 -> free, the root
/// fixed -> elastic_hinge 1 -> conn 2
/// fixed -> elastic_hinge 5 -> conn 4
/// ```
#[derive(::core::clone::Clone, ::core::fmt::Debug)]
pub struct RestrainedBeamSystem<T: mstmm::__private::Real = f64> {
    /// `elastic_hinge 1`
    element_1: <mstmm::__private::elements::ElasticHinge<
        T,
    > as mstmm::__private::Element>::Built,
    /// `beam 3`
    element_3: <mstmm::__private::elements::Beam<T> as mstmm::__private::Element>::Built,
    /// `elastic_hinge 5`
    element_5: <mstmm::__private::elements::ElasticHinge<
        T,
    > as mstmm::__private::Element>::Built,
    /// The field `length`
    field_length: ::core::primitive::f64,
    /// The field `bending_stiffness`
    field_bending_stiffness: ::core::primitive::f64,
    /// The field `mass_per_length`
    field_mass_per_length: ::core::primitive::f64,
    /// The field `left_stiffness`
    field_left_stiffness: ::core::primitive::f64,
    /// The field `left_torsion`
    field_left_torsion: ::core::primitive::f64,
    /// The field `right_stiffness`
    field_right_stiffness: ::core::primitive::f64,
    /// The field `right_torsion`
    field_right_torsion: ::core::primitive::f64,
    parameter: ::core::marker::PhantomData<T>,
}
impl RestrainedBeam {
    /// Validates all parameters and builds the system.
    ///
    /// # Errors
    /// The error names the first element with a parameter out of its range, the parameter and its value.
    pub fn build(
        &self,
    ) -> ::core::result::Result<RestrainedBeamSystem, mstmm::__private::ParameterError> {
        self.build_as()
    }
    /// Builds the system over another scalar, such as `f32` or the double-double `DoubleDouble`.
    ///
    /// # Errors
    /// As `build`.
    pub fn build_as<T: mstmm::__private::Real>(
        &self,
    ) -> ::core::result::Result<
        RestrainedBeamSystem<T>,
        mstmm::__private::ParameterError,
    > {
        let length = self.length;
        let bending_stiffness = self.bending_stiffness;
        let mass_per_length = self.mass_per_length;
        let left_stiffness = self.left_stiffness;
        let left_torsion = self.left_torsion;
        let right_stiffness = self.right_stiffness;
        let right_torsion = self.right_torsion;
        ::core::result::Result::Ok(RestrainedBeamSystem {
            element_1: mstmm::__private::build::<
                mstmm::__private::elements::ElasticHinge<T>,
            >(
                mstmm::__private::elements::ElasticHinge {
                    stiffness_y: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = left_stiffness;
                        number
                    }),
                    stiffness_theta: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = left_torsion;
                        number
                    }),
                },
                "elastic_hinge 1",
            )?,
            element_3: mstmm::__private::build::<
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
                "beam 3",
            )?,
            element_5: mstmm::__private::build::<
                mstmm::__private::elements::ElasticHinge<T>,
            >(
                mstmm::__private::elements::ElasticHinge {
                    stiffness_y: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = right_stiffness;
                        number
                    }),
                    stiffness_theta: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = right_torsion;
                        number
                    }),
                },
                "elastic_hinge 5",
            )?,
            field_length: self.length,
            field_bending_stiffness: self.bending_stiffness,
            field_mass_per_length: self.mass_per_length,
            field_left_stiffness: self.left_stiffness,
            field_left_torsion: self.left_torsion,
            field_right_stiffness: self.right_stiffness,
            field_right_torsion: self.right_torsion,
            parameter: ::core::marker::PhantomData,
        })
    }
}
#[automatically_derived]
impl<T: mstmm::__private::Real> mstmm::__private::System for RestrainedBeamSystem<T> {
    type Parameter = T;
    fn estimates(&self) -> mstmm::__private::FrequencyEstimates {
        let mut estimates = ::core::default::Default::default();
        <mstmm::__private::elements::ElasticHinge<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_1, &mut estimates);
        <mstmm::__private::elements::Beam<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_3, &mut estimates);
        <mstmm::__private::elements::ElasticHinge<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_5, &mut estimates);
        estimates
    }
}
/// The labels of the sketch: elements and connections, as results about motions take them.
#[allow(dead_code, non_upper_case_globals)]
impl RestrainedBeam {
    /// `elastic_hinge 1`
    pub const elastic_hinge_1: mstmm::__private::Label<
        RestrainedBeam,
        mstmm::__private::elements::ElasticHinge<f64>,
    > = mstmm::__private::Label::new(2usize, 1usize);
    /// `conn 2`
    pub const conn_2: mstmm::__private::Point<RestrainedBeam> = mstmm::__private::Point::connection(
        3usize,
    );
    /// `beam 3`
    pub const beam_3: mstmm::__private::Label<
        RestrainedBeam,
        mstmm::__private::elements::Beam<f64>,
    > = mstmm::__private::Label::new(4usize, 3usize);
    /// `elastic_hinge 5`
    pub const elastic_hinge_5: mstmm::__private::Label<
        RestrainedBeam,
        mstmm::__private::elements::ElasticHinge<f64>,
    > = mstmm::__private::Label::new(6usize, 5usize);
    /// `conn 4`
    pub const conn_4: mstmm::__private::Point<RestrainedBeam> = mstmm::__private::Point::connection(
        7usize,
    );
}
#[automatically_derived]
impl<T: mstmm::__private::Real> mstmm::__private::Fields for RestrainedBeamSystem<T> {
    const NAMES: &'static [&'static ::core::primitive::str] = &[
        "length",
        "bending_stiffness",
        "mass_per_length",
        "left_stiffness",
        "left_torsion",
        "right_stiffness",
        "right_torsion",
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
impl<T, S> mstmm::__private::Chain<S> for RestrainedBeamSystem<T>
where
    T: mstmm::__private::Real,
    S: mstmm::__private::Frequency<T>,
    mstmm::__private::elements::Beam<
        T,
    >: mstmm::__private::Energies<S, Gradient = mstmm::__private::elements::Beam<S>>,
    mstmm::__private::elements::ElasticHinge<
        T,
    >: mstmm::__private::Energies<
        S,
        Gradient = mstmm::__private::elements::ElasticHinge<S>,
    >,
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
        let left_stiffness = chain.variable(self.field_left_stiffness);
        let left_torsion = chain.variable(self.field_left_torsion);
        let right_stiffness = chain.variable(self.field_right_stiffness);
        let right_torsion = chain.variable(self.field_right_torsion);
        let values = (left_stiffness, left_torsion);
        for step in [2usize] {
            let gradient = <mstmm::__private::elements::ElasticHinge<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_1, &ends(step));
            chain.add(gradient.stiffness_y, values.0);
            chain.add(gradient.stiffness_theta, values.1);
        }
        let values = (length, bending_stiffness, mass_per_length);
        for step in [4usize] {
            let gradient = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_3, &ends(step));
            chain.add(gradient.length, values.0);
            chain.add(gradient.bending_stiffness, values.1);
            chain.add(gradient.mass_per_length, values.2);
        }
        let values = (right_stiffness, right_torsion);
        for step in [6usize] {
            let gradient = <mstmm::__private::elements::ElasticHinge<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_5, &ends(step));
            chain.add(gradient.stiffness_y, values.0);
            chain.add(gradient.stiffness_theta, values.1);
        }
        chain.finish()
    }
}
const _: () = {
    const LAYOUT: mstmm::__private::Scheme<'static> = const {
        &mstmm::__private::Layout::new([
            mstmm::__private::Step::Tip(mstmm::__private::Support::Free),
            mstmm::__private::Step::Tip(mstmm::__private::Support::Fixed),
            mstmm::__private::Step::Element(
                1usize,
                mstmm::__private::space_of::<
                    mstmm::__private::elements::ElasticHinge<f64>,
                >(),
            ),
            mstmm::__private::Step::Connection(&[0usize, 2usize]),
            mstmm::__private::Step::Element(
                3usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Beam<f64>>(),
            ),
            mstmm::__private::Step::Tip(mstmm::__private::Support::Fixed),
            mstmm::__private::Step::Element(
                5usize,
                mstmm::__private::space_of::<
                    mstmm::__private::elements::ElasticHinge<f64>,
                >(),
            ),
            mstmm::__private::Step::Connection(&[4usize, 6usize]),
            mstmm::__private::Step::Root(7usize, mstmm::__private::Support::Free),
        ])
    }
        .scheme();
    const _: () = LAYOUT.check_support(0usize);
    const _: () = LAYOUT.check_support(1usize);
    const _: () = LAYOUT.check_arrow(2usize);
    const _: () = LAYOUT.check_connection(3usize);
    const _: () = LAYOUT.check_arrow(4usize);
    const _: () = LAYOUT.check_support(5usize);
    const _: () = LAYOUT.check_arrow(6usize);
    const _: () = LAYOUT.check_connection(7usize);
    const _: () = LAYOUT.check_support(8usize);
    impl RestrainedBeamSystem {
        /// Width of the reduced overall matrix: the number of unknowns at the boundaries.
        pub const N: usize = 8;
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Evaluate<S> for RestrainedBeamSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::TransferMatrix<S>,
        mstmm::__private::elements::ElasticHinge<T>: mstmm::__private::TransferMatrix<S>,
    {
        type Matrix = mstmm::__private::SMatrix<S, 8, 8>;
        fn overall_matrix(&self, x: S) -> Self::Matrix {
            let u_1 = <mstmm::__private::elements::ElasticHinge<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_1, x);
            let u_3 = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_3, x);
            let u_5 = <mstmm::__private::elements::ElasticHinge<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_5, x);
            let mut equation = mstmm::__private::Assembly::new(LAYOUT);
            equation
                .element::<mstmm::__private::elements::ElasticHinge<T>>(2usize, &u_1);
            equation.connection(3usize);
            equation.element::<mstmm::__private::elements::Beam<T>>(4usize, &u_3);
            equation
                .element::<mstmm::__private::elements::ElasticHinge<T>>(6usize, &u_5);
            equation.connection(7usize);
            equation.finish()
        }
        fn overall_determinant(&self, x: S) -> mstmm::__private::Scaled<S> {
            let determinant = mstmm::__private::determinant(
                mstmm::__private::Evaluate::overall_matrix(self, x),
            );
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::ElasticHinge<T>,
                S,
            >(determinant, &self.element_1, x);
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::Beam<T>,
                S,
            >(determinant, &self.element_3, x);
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::ElasticHinge<T>,
                S,
            >(determinant, &self.element_5, x);
            determinant
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Characteristic<S> for RestrainedBeamSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::ElasticHinge<T>: mstmm::__private::PlaneStep<S>,
    {
        #[inline]
        fn pass<C: mstmm::__private::RootCounter<S>>(
            &self,
            x: S,
            counter: &mut C,
        ) -> mstmm::__private::Scaled<S> {
            const STEPS: usize = 9usize;
            let at = mstmm::__private::FrequencyPowers::new(
                x,
                false
                    || <mstmm::__private::elements::Beam<
                        T,
                    > as mstmm::__private::PlaneStep<S>>::WAVES
                    || <mstmm::__private::elements::ElasticHinge<
                        T,
                    > as mstmm::__private::PlaneStep<S>>::WAVES,
            );
            let k_1 = mstmm::__private::coefficients::<
                mstmm::__private::elements::ElasticHinge<T>,
                S,
                STEPS,
            >(&self.element_1, &at);
            let k_3 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Beam<T>,
                S,
                STEPS,
            >(&self.element_3, &at);
            let k_5 = mstmm::__private::coefficients::<
                mstmm::__private::elements::ElasticHinge<T>,
                S,
                STEPS,
            >(&self.element_5, &at);
            let s1 = mstmm::__private::Subspace::Tip(
                mstmm::__private::Support::Fixed,
                const { LAYOUT.space(1usize) },
            );
            let s2 = mstmm::__private::step::<
                mstmm::__private::elements::ElasticHinge<T>,
                S,
                C,
                STEPS,
            >(&k_1, s1, counter);
            let s3 = s2;
            let s3 = mstmm::__private::widened(s3, const { LAYOUT.output(3usize) });
            let s3 = mstmm::__private::held(s3, mstmm::__private::Support::Free);
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
                mstmm::__private::Support::Fixed,
                const { LAYOUT.space(5usize) },
            );
            let s6 = mstmm::__private::step::<
                mstmm::__private::elements::ElasticHinge<T>,
                S,
                C,
                STEPS,
            >(&k_5, s5, counter);
            let s7 = s4;
            let s7 = mstmm::__private::join::<S, C, true, STEPS>(s7, s6, counter);
            let s7 = mstmm::__private::widened(s7, const { LAYOUT.output(7usize) });
            let s7 = mstmm::__private::narrowed(
                s7,
                const { LAYOUT.output(7usize) },
                counter,
            );
            s7.at_root(mstmm::__private::Support::Free, counter)
        }
    }
    #[automatically_derived]
    impl<T: mstmm::__private::Real> mstmm::__private::Planned
    for RestrainedBeamSystem<T> {
        type Model = RestrainedBeam;
        type PerStep<C: ::core::marker::Copy + ::core::fmt::Debug> = [C; 9usize];
        fn per_step<C: ::core::marker::Copy + ::core::fmt::Debug>(
            value: C,
        ) -> [C; 9usize] {
            [value; 9usize]
        }
        fn scheme() -> mstmm::__private::Scheme<'static> {
            LAYOUT
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Tree<S> for RestrainedBeamSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::ElasticHinge<T>: mstmm::__private::Energies<S>,
    {
        type Evaluated = (
            <mstmm::__private::elements::ElasticHinge<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
            <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
            <mstmm::__private::elements::ElasticHinge<
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
                    || <mstmm::__private::elements::ElasticHinge<
                        T,
                    > as mstmm::__private::PlaneStep<S>>::WAVES,
            )
        }
        fn evaluate(
            &self,
            at: &mstmm::__private::FrequencyPowers<S>,
        ) -> Self::Evaluated {
            (
                <mstmm::__private::elements::ElasticHinge<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_1, at),
                <mstmm::__private::elements::Beam<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_3, at),
                <mstmm::__private::elements::ElasticHinge<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_5, at),
            )
        }
        fn visit<C: mstmm::__private::Visit<S>>(
            &self,
            step: usize,
            visitor: C,
        ) -> ::core::option::Option<C::Output> {
            ::core::option::Option::Some(
                match step {
                    2usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::ElasticHinge<T>,
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
                                mstmm::__private::elements::ElasticHinge<T>,
                            >(&self.element_5)
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
                    2usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::ElasticHinge<T>,
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
                                mstmm::__private::elements::ElasticHinge<T>,
                            >(&self.element_5, &evaluated.2)
                    }
                    _ => return ::core::option::Option::None,
                },
            )
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::TreeInBlocks<S> for RestrainedBeamSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::ElasticHinge<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::Beam<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::ElasticHinge<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Beam<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
        mstmm::__private::elements::ElasticHinge<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
    {
        fn visit_in_block<C: mstmm::__private::VisitInBlock<S>>(
            &self,
            step: usize,
            visitor: C,
        ) {
            match step {
                2usize => {
                    visitor
                        .element::<
                            mstmm::__private::elements::ElasticHinge<T>,
                        >(&self.element_1)
                }
                4usize => {
                    visitor
                        .element::<mstmm::__private::elements::Beam<T>>(&self.element_3)
                }
                6usize => {
                    visitor
                        .element::<
                            mstmm::__private::elements::ElasticHinge<T>,
                        >(&self.element_5)
                }
                _ => {}
            }
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Walk<S> for RestrainedBeamSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::ElasticHinge<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Beam<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::ElasticHinge<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Beam<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
        mstmm::__private::elements::ElasticHinge<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
    {
        fn walk<C: mstmm::__private::Walker<S>>(&self, walker: &mut C) {
            walker.tip(mstmm::__private::Support::Free, const { LAYOUT.space(0usize) });
            walker.tip(mstmm::__private::Support::Fixed, const { LAYOUT.space(1usize) });
            walker
                .element::<mstmm::__private::elements::ElasticHinge<T>>(&self.element_1);
            walker.connection(&[1, 0], const { LAYOUT.output(3usize) });
            walker.element::<mstmm::__private::elements::Beam<T>>(&self.element_3);
            walker.tip(mstmm::__private::Support::Fixed, const { LAYOUT.space(5usize) });
            walker
                .element::<mstmm::__private::elements::ElasticHinge<T>>(&self.element_5);
            walker.connection(&[1, 0], const { LAYOUT.output(7usize) });
            walker.root(mstmm::__private::Support::Free);
        }
    }
};
