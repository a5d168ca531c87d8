/// A mass between a spring and a damper.
#[derive(Debug)]
pub struct DampedMass {
    /// Stiffness [N/m].
    pub stiffness: f64,
    /// Damping [N s/m].
    pub damping: f64,
    /// Mass [kg].
    pub mass: f64,
}
/// The built system of [`DampedMass`]: evaluate it at a frequency, or search its frequencies.
///
/// # Equation
///
/// `s0` is the state behind step 0 below, `U` the transfer matrix of an element. Where paths meet, the first gives the
/// displacements, and each its forces: `F` takes the forces of a state alone. `P` takes of a state what goes on to fewer.
///
/// ```text
/// U_all z_all = 0, 3 x 3: 2 rows of the main transfer equation, geometrical equations: 1
/// z_all = [Q(s0), Q(s2), Y(s6)]
/// s6 = U(mass 4) U(spring 1) s0
///     + U(mass 4) F U(damper 3) s2
/// Y(s3) = Y(s1)
/// ```
///
/// # Steps
///
/// ```text
/// s0   = fixed                           translation
/// s1   = spring 1 (s0)                   translation
/// s2   = fixed                           translation
/// s3   = damper 3 (s2)                   translation
/// s4   = conn 2 (s1, s3)                 translation
/// s5   = mass 4 (s4)                     translation
/// s6   = free, the root (s5)             translation
/// ```
///
/// # Paths
///
/// ```text
/// fixed -> spring 1 -> conn 2 -> mass 4 -> free, the root
/// fixed -> damper 3 -> conn 2
/// ```
#[derive(::core::clone::Clone, ::core::fmt::Debug)]
pub struct DampedMassSystem<T: mstmm::__private::Parameter = f64> {
    /// `spring 1`
    element_1: <mstmm::__private::elements::Spring<
        T,
    > as mstmm::__private::Element>::Built,
    /// `damper 3`
    element_3: <mstmm::__private::elements::Damper<
        T,
    > as mstmm::__private::Element>::Built,
    /// `mass 4`
    element_4: <mstmm::__private::elements::Mass<T> as mstmm::__private::Element>::Built,
    /// The field `stiffness`
    field_stiffness: ::core::primitive::f64,
    /// The field `damping`
    field_damping: ::core::primitive::f64,
    /// The field `mass`
    field_mass: ::core::primitive::f64,
    estimates: mstmm::__private::FrequencyEstimates,
    parameter: ::core::marker::PhantomData<T>,
}
impl DampedMass {
    /// Validates all parameters and builds the system.
    ///
    /// # Errors
    /// The error names the first element with a parameter out of its range, the parameter and its value.
    pub fn build(
        &self,
    ) -> ::core::result::Result<DampedMassSystem, mstmm::__private::ParameterError> {
        self.build_as()
    }
    /// Builds the system over another scalar, such as `f32` or the double-double `DoubleDouble`.
    ///
    /// # Errors
    /// As `build`.
    pub fn build_as<T: mstmm::__private::Real>(
        &self,
    ) -> ::core::result::Result<DampedMassSystem<T>, mstmm::__private::ParameterError> {
        mstmm::__private::Build::build_of(
            self,
            &mstmm::__private::Numbered::numbers(self),
        )
    }
}
impl mstmm::__private::Numbered for DampedMass {
    type Numbers = [::core::primitive::f64; 3usize];
    fn numbers(&self) -> [::core::primitive::f64; 3usize] {
        let stiffness = self.stiffness;
        let damping = self.damping;
        let mass = self.mass;
        [
            {
                let number: ::core::primitive::f64 = stiffness;
                number
            },
            {
                let number: ::core::primitive::f64 = damping;
                number
            },
            {
                let number: ::core::primitive::f64 = mass;
                number
            },
        ]
    }
}
#[automatically_derived]
impl mstmm::__private::Build for DampedMass {
    type System<T: mstmm::__private::Parameter> = DampedMassSystem<T>;
    fn build_of<T: mstmm::__private::Real>(
        &self,
        numbers: &Self::Numbers,
    ) -> ::core::result::Result<DampedMassSystem<T>, mstmm::__private::ParameterError> {
        let mut system = mstmm::__private::Model::of_numbers(
            self,
            |k: ::core::primitive::usize| mstmm::__private::Scalar::from_f64(numbers[k]),
        )?;
        <mstmm::__private::elements::Spring<
            T,
        > as mstmm::__private::Element>::estimate(
            &system.element_1,
            &mut system.estimates,
        );
        <mstmm::__private::elements::Damper<
            T,
        > as mstmm::__private::Element>::estimate(
            &system.element_3,
            &mut system.estimates,
        );
        <mstmm::__private::elements::Mass<
            T,
        > as mstmm::__private::Element>::estimate(
            &system.element_4,
            &mut system.estimates,
        );
        system.estimates.finish();
        ::core::result::Result::Ok(system)
    }
}
#[automatically_derived]
impl mstmm::__private::Model for DampedMass {
    type System<T: mstmm::__private::Parameter> = DampedMassSystem<T>;
    fn build(
        &self,
    ) -> ::core::result::Result<DampedMassSystem, mstmm::__private::ParameterError> {
        self.build_as()
    }
    fn of_numbers<T: mstmm::__private::Parameter>(
        &self,
        number: impl ::core::ops::Fn(::core::primitive::usize) -> T,
    ) -> ::core::result::Result<DampedMassSystem<T>, mstmm::__private::ParameterError> {
        ::core::result::Result::Ok(DampedMassSystem {
            element_1: mstmm::__private::build::<
                mstmm::__private::elements::Spring<T>,
            >(
                mstmm::__private::elements::Spring {
                    stiffness: number(0usize),
                },
                "spring 1",
            )?,
            element_3: mstmm::__private::build::<
                mstmm::__private::elements::Damper<T>,
            >(
                mstmm::__private::elements::Damper {
                    damping: number(1usize),
                },
                "damper 3",
            )?,
            element_4: mstmm::__private::build::<
                mstmm::__private::elements::Mass<T>,
            >(
                mstmm::__private::elements::Mass {
                    mass: number(2usize),
                },
                "mass 4",
            )?,
            field_stiffness: self.stiffness,
            field_damping: self.damping,
            field_mass: self.mass,
            estimates: ::core::default::Default::default(),
            parameter: ::core::marker::PhantomData,
        })
    }
}
/// The labels of the sketch: elements and connections, as results about motions take them.
#[allow(dead_code, non_upper_case_globals)]
impl DampedMass {
    /// `spring 1`
    pub const spring_1: mstmm::__private::Label<
        DampedMass,
        mstmm::__private::elements::Spring<f64>,
    > = mstmm::__private::Label::new(1usize, 0usize);
    /// `damper 3`
    pub const damper_3: mstmm::__private::Label<
        DampedMass,
        mstmm::__private::elements::Damper<f64>,
    > = mstmm::__private::Label::new(3usize, 2usize);
    /// `conn 2`
    pub const conn_2: mstmm::__private::Point<DampedMass> = mstmm::__private::Point::connection(
        4usize,
    );
    /// `mass 4`
    pub const mass_4: mstmm::__private::Label<
        DampedMass,
        mstmm::__private::elements::Mass<f64>,
    > = mstmm::__private::Label::new(5usize, 4usize);
}
#[automatically_derived]
impl<T: mstmm::__private::Real> mstmm::__private::NamedFields for DampedMassSystem<T> {
    const NAMES: &'static [&'static ::core::primitive::str] = &[
        "stiffness",
        "damping",
        "mass",
    ];
}
#[automatically_derived]
impl<T: mstmm::__private::Real> mstmm::__private::Fields for DampedMassSystem<T> {
    type PerField<V: ::core::marker::Copy + ::core::fmt::Debug> = [V; <[()]>::len(
        &[(), (), ()],
    )];
    fn per_field<V: ::core::marker::Copy + ::core::fmt::Debug>(
        value: V,
    ) -> Self::PerField<V> {
        [value; _]
    }
}
#[automatically_derived]
#[allow(unused_braces)]
impl<T, S> mstmm::__private::Chain<S> for DampedMassSystem<T>
where
    T: mstmm::__private::Real,
    S: mstmm::__private::Frequency<T>,
    mstmm::__private::elements::Damper<
        T,
    >: mstmm::__private::Energies<S, Gradient = mstmm::__private::elements::Damper<S>>,
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
        let stiffness = chain.variable(self.field_stiffness);
        let damping = chain.variable(self.field_damping);
        let mass = chain.variable(self.field_mass);
        let values = (stiffness,);
        for step in [1usize] {
            let gradient = <mstmm::__private::elements::Spring<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_1, &ends(step));
            chain.add(gradient.stiffness, values.0);
        }
        let values = (damping,);
        for step in [3usize] {
            let gradient = <mstmm::__private::elements::Damper<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_3, &ends(step));
            chain.add(gradient.damping, values.0);
        }
        let values = (mass,);
        for step in [5usize] {
            let gradient = <mstmm::__private::elements::Mass<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_4, &ends(step));
            chain.add(gradient.mass, values.0);
        }
        chain.finish()
    }
}
#[automatically_derived]
impl mstmm::__private::Formulas for DampedMass {
    type Built = DampedMassSystem;
    const COMPARES: ::core::primitive::bool = false;
    #[inline]
    fn values(
        &self,
    ) -> <DampedMassSystem as mstmm::__private::Fields>::PerField<
        ::core::primitive::f64,
    > {
        [self.stiffness, self.damping, self.mass]
    }
    #[inline]
    fn built(
        &self,
        numbers: &Self::Numbers,
    ) -> ::core::result::Result<DampedMassSystem, mstmm::__private::ParameterError> {
        mstmm::__private::Build::build_of(self, numbers)
    }
    #[inline]
    #[allow(unused_braces)]
    fn enclose(
        &self,
        fields: &<DampedMassSystem as mstmm::__private::Fields>::PerField<
            mstmm::__private::Interval,
        >,
        take: &mut dyn ::core::ops::FnMut(
            ::core::primitive::usize,
            mstmm::__private::Interval,
            &[mstmm::__private::Interval],
        ),
    ) {
        let mut chain = mstmm::__private::Enclosing::new(fields);
        let stiffness = chain.variable();
        let damping = chain.variable();
        let mass = chain.variable();
        let number = stiffness;
        take(0usize, number.value, &number.partials);
        let number = damping;
        take(1usize, number.value, &number.partials);
        let number = mass;
        take(2usize, number.value, &number.partials);
    }
}
const _: () = {
    const LAYOUT: mstmm::__private::Scheme<'static> = const {
        &mstmm::__private::Layout::new([
            mstmm::__private::Step::Tip(mstmm::__private::Support::Fixed),
            mstmm::__private::Step::Element(
                0usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Spring<f64>>(),
            ),
            mstmm::__private::Step::Tip(mstmm::__private::Support::Fixed),
            mstmm::__private::Step::Element(
                2usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Damper<f64>>(),
            ),
            mstmm::__private::Step::Connection(&[1usize, 3usize]),
            mstmm::__private::Step::Element(
                4usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Mass<f64>>(),
            ),
            mstmm::__private::Step::Root(5usize, mstmm::__private::Support::Free),
        ])
    }
        .scheme();
    impl DampedMassSystem {
        /// Width of the reduced overall matrix: the number of unknowns at the boundaries.
        pub const N: usize = 3;
    }
    #[automatically_derived]
    impl<T: mstmm::__private::Real> mstmm::__private::System for DampedMassSystem<T> {
        type Parameter = T;
        const STANDS_IN_LINE: bool = 7usize <= mstmm::__private::LONGEST_IN_LANES
            && Self::HAS_PHASES;
        const HAS_PHASES: bool = <mstmm::__private::elements::Damper<
            T,
        > as mstmm::__private::Element>::IS_STRAIGHT
            && <mstmm::__private::elements::Mass<
                T,
            > as mstmm::__private::Element>::IS_STRAIGHT
            && <mstmm::__private::elements::Spring<
                T,
            > as mstmm::__private::Element>::IS_STRAIGHT;
        const MAY_BUCKLE: bool = <mstmm::__private::elements::Damper<
            T,
        > as mstmm::__private::Element>::MAY_BUCKLE
            || <mstmm::__private::elements::Mass<
                T,
            > as mstmm::__private::Element>::MAY_BUCKLE
            || <mstmm::__private::elements::Spring<
                T,
            > as mstmm::__private::Element>::MAY_BUCKLE;
        fn name_parts(&self, visitor: &mut dyn mstmm::__private::Visitor) {
            let numbers = |step: ::core::primitive::usize| match step {
                1usize => {
                    <mstmm::__private::elements::Spring<
                        T,
                    > as mstmm::__private::Element>::member_numbers(&self.element_1)
                }
                3usize => {
                    <mstmm::__private::elements::Damper<
                        T,
                    > as mstmm::__private::Element>::member_numbers(&self.element_3)
                }
                5usize => {
                    <mstmm::__private::elements::Mass<
                        T,
                    > as mstmm::__private::Element>::member_numbers(&self.element_4)
                }
                _ => mstmm::__private::MemberNumbers::Other,
            };
            mstmm::__private::visit_steps(LAYOUT, &numbers, visitor);
        }
        fn spot_of(&self, place: ::core::primitive::usize) -> mstmm::__private::Spot {
            mstmm::__private::Spot::Named(
                [
                    "fixed",
                    "spring 1",
                    "fixed",
                    "damper 3",
                    "conn 2",
                    "mass 4",
                    "free",
                ][place],
            )
        }
        fn frequency_estimates(&self) -> mstmm::__private::FrequencyEstimates {
            self.estimates
        }
    }
    #[automatically_derived]
    #[allow(unused_braces)]
    impl<T, S> mstmm::__private::Evaluate<S> for DampedMassSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Damper<T>: mstmm::__private::TransferMatrix<S>,
        mstmm::__private::elements::Mass<T>: mstmm::__private::TransferMatrix<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::TransferMatrix<S>,
        S: mstmm::__private::Single,
    {
        type Matrix = mstmm::__private::SMatrix<S, 3, 3>;
        fn overall_matrix(&self, x: S) -> Self::Matrix {
            let u_1 = <mstmm::__private::elements::Spring<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_1, x);
            let u_3 = <mstmm::__private::elements::Damper<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_3, x);
            let u_4 = <mstmm::__private::elements::Mass<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_4, x);
            let mut equation = mstmm::__private::Assembly::new(&LAYOUT);
            equation.tip(0usize);
            equation.element::<mstmm::__private::elements::Spring<T>>(1usize, &u_1);
            equation.tip(2usize);
            equation.element::<mstmm::__private::elements::Damper<T>>(3usize, &u_3);
            equation.connection(4usize);
            equation.element::<mstmm::__private::elements::Mass<T>>(5usize, &u_4);
            equation.finish()
        }
        fn overall_determinant(&self, x: S) -> mstmm::__private::Scaled<S> {
            let determinant = mstmm::__private::determinant(
                mstmm::__private::Evaluate::overall_matrix(self, x),
            );
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::Spring<T>,
                S,
            >(determinant, &self.element_1, x);
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::Damper<T>,
                S,
            >(determinant, &self.element_3, x);
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::Mass<T>,
                S,
            >(determinant, &self.element_4, x);
            determinant
        }
    }
    #[automatically_derived]
    #[allow(unused_braces)]
    impl<T, S> mstmm::__private::Characteristic<S> for DampedMassSystem<T>
    where
        T: mstmm::__private::Parameter,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Damper<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Mass<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::PlaneStep<S>,
    {
        #[inline(always)]
        fn pass<C: mstmm::__private::RootCounter<S>>(
            &self,
            x: S,
            counter: &mut C,
        ) -> mstmm::__private::Scaled<S> {
            const STEPS: usize = 7usize;
            let at = mstmm::__private::FrequencyPowers::new(
                x,
                false
                    || <mstmm::__private::elements::Damper<
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
                mstmm::__private::elements::Spring<T>,
                S,
                STEPS,
            >(&self.element_1, &at);
            let k_3 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Damper<T>,
                S,
                STEPS,
            >(&self.element_3, &at);
            let k_4 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Mass<T>,
                S,
                STEPS,
            >(&self.element_4, &at);
            let s0 = mstmm::__private::Subspace::Tip(
                mstmm::__private::Support::Fixed,
                const { LAYOUT.space(0usize) },
            );
            let s1 = mstmm::__private::step::<
                mstmm::__private::elements::Spring<T>,
                S,
                C,
                STEPS,
            >(&k_1, s0, counter);
            let s2 = mstmm::__private::Subspace::Tip(
                mstmm::__private::Support::Fixed,
                const { LAYOUT.space(2usize) },
            );
            let s3 = mstmm::__private::step::<
                mstmm::__private::elements::Damper<T>,
                S,
                C,
                STEPS,
            >(&k_3, s2, counter);
            let s4 = s1;
            let s4 = mstmm::__private::join::<S, C, true, STEPS>(s4, s3, counter);
            let s4 = mstmm::__private::Connecting::widened(
                s4,
                const { LAYOUT.output(4usize) },
            );
            let s4 = mstmm::__private::Connecting::narrowed(
                s4,
                const { LAYOUT.output(4usize) },
                counter,
            );
            mstmm::__private::root::<
                mstmm::__private::elements::Mass<T>,
                S,
                C,
                STEPS,
            >(&k_4, s4, mstmm::__private::Support::Free, counter)
        }
    }
    #[automatically_derived]
    impl<T: mstmm::__private::Real> mstmm::__private::Planned for DampedMassSystem<T> {
        type Model = DampedMass;
        type PerStep<C: ::core::marker::Copy + ::core::fmt::Debug> = [C; 7usize];
        fn per_step<C: ::core::marker::Copy + ::core::fmt::Debug>(
            value: C,
        ) -> [C; 7usize] {
            [value; 7usize]
        }
        fn scheme(&self) -> mstmm::__private::Scheme<'_> {
            LAYOUT
        }
    }
    #[automatically_derived]
    #[allow(unused_braces)]
    impl<T, S> mstmm::__private::Tree<S> for DampedMassSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Damper<T>: mstmm::__private::Moving<S>,
        mstmm::__private::elements::Mass<T>: mstmm::__private::Moving<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::Moving<S>,
    {
        type Evaluated = (
            <mstmm::__private::elements::Spring<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
            <mstmm::__private::elements::Damper<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
            <mstmm::__private::elements::Mass<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
        );
        fn at(x: S) -> mstmm::__private::FrequencyPowers<S> {
            mstmm::__private::FrequencyPowers::new(
                x,
                false
                    || <mstmm::__private::elements::Damper<
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
                <mstmm::__private::elements::Spring<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_1, at),
                <mstmm::__private::elements::Damper<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_3, at),
                <mstmm::__private::elements::Mass<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_4, at),
            )
        }
        fn visit<C: mstmm::__private::Visit<S>>(
            &self,
            evaluated: ::core::option::Option<&Self::Evaluated>,
            step: usize,
            visitor: C,
        ) -> ::core::option::Option<C::Output> {
            ::core::option::Option::Some(
                match step {
                    1usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Spring<T>,
                            >(&self.element_1, evaluated.map(|evaluated| &evaluated.0))
                    }
                    3usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Damper<T>,
                            >(&self.element_3, evaluated.map(|evaluated| &evaluated.1))
                    }
                    5usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Mass<T>,
                            >(&self.element_4, evaluated.map(|evaluated| &evaluated.2))
                    }
                    _ => return ::core::option::Option::None,
                },
            )
        }
    }
    #[automatically_derived]
    impl<T: mstmm::__private::Real> mstmm::__private::DrawnTree for DampedMassSystem<T>
    where
        mstmm::__private::elements::Damper<T>: mstmm::__private::Element,
        mstmm::__private::elements::Mass<T>: mstmm::__private::Element,
        mstmm::__private::elements::Spring<T>: mstmm::__private::Element,
    {
        fn drawn(
            &self,
            step: ::core::primitive::usize,
        ) -> ::core::option::Option<
            (&'static ::core::primitive::str, mstmm::__private::Extent),
        > {
            ::core::option::Option::Some(
                match step {
                    1usize => {
                        (
                            "Spring",
                            <mstmm::__private::elements::Spring<
                                T,
                            > as mstmm::__private::Element>::extent(&self.element_1),
                        )
                    }
                    3usize => {
                        (
                            "Damper",
                            <mstmm::__private::elements::Damper<
                                T,
                            > as mstmm::__private::Element>::extent(&self.element_3),
                        )
                    }
                    5usize => {
                        (
                            "Mass",
                            <mstmm::__private::elements::Mass<
                                T,
                            > as mstmm::__private::Element>::extent(&self.element_4),
                        )
                    }
                    _ => return ::core::option::Option::None,
                },
            )
        }
    }
    #[automatically_derived]
    impl<T> mstmm::__private::search::Undamped for DampedMassSystem<T>
    where
        T: mstmm::__private::Real + mstmm::__private::InLanes,
        Self: mstmm::__private::search::RealPasses,
    {}
    #[automatically_derived]
    impl<T: mstmm::__private::Real> mstmm::__private::search::Spectrum
    for DampedMassSystem<T>
    where
        Self: mstmm::__private::search::ComplexPasses,
    {}
};
