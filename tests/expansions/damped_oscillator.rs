/// Simply supported beam with a grounded spring, a damped oscillator and a grounded torsion spring (section 4.5).
#[derive(Clone, Copy, Debug)]
pub struct DampedOscillator {
    /// Beam length l [m]
    pub length: f64,
    /// Bending stiffness EI of the beam [N m²]
    pub bending_stiffness: f64,
    /// Mass per length m of the beam [kg/m]
    pub mass_per_length: f64,
    /// Position x_1 of the grounded spring [m]
    pub spring_position: f64,
    /// Position x_2 of the oscillator [m]
    pub oscillator_position: f64,
    /// Position x_3 of the torsion spring [m]
    pub torsion_position: f64,
    /// Stiffness K_y1 of the grounded spring [N/m]
    pub spring_stiffness: f64,
    /// Stiffness K_y2 of the oscillator [N/m]
    pub oscillator_stiffness: f64,
    /// Damping C of the oscillator [N s/m]
    pub damping: f64,
    /// Mass of the oscillator [kg]
    pub mass: f64,
    /// Stiffness K'_z of the torsion spring [N m/rad]
    pub torsion_stiffness: f64,
}
/// The built system of [`DampedOscillator`]: evaluate it at a frequency, or search its frequencies.
///
/// # Equation
///
/// `s0` is the state behind step 0 below, `U` the transfer matrix of an element. Where paths meet, the first gives the
/// displacements, and each its forces: `F` takes the forces of a state alone. `P` takes of a state what goes on to fewer.
///
/// ```text
/// U_all z_all = 0, 7 x 7: 4 rows of the main transfer equation, geometrical equations: 3
/// z_all = [Θ(s0), Q(s0), Q(s2), Y(s6), M(s11), Θ(s15), Q(s15)]
/// s15 = U(beam 11) U(beam 8) U(beam 4) U(beam 1) s0
///     + U(beam 11) U(beam 8) U(beam 4) F U(spring 3) s2
///     + U(beam 11) U(beam 8) F U(spring_damper 6) U(mass 7) s6
///     + U(beam 11) F U(torsion_spring 10) s11
/// Y(s3) = Y(s1)
/// Y(s8) = Y(s5)
/// Θ(s12) = Θ(s10)
/// ```
///
/// # Steps
///
/// ```text
/// s0   = pinned                          bending
/// s1   = beam 1 (s0)                     bending
/// s2   = fixed                           translation
/// s3   = spring 3 (s2)                   translation
/// s4   = conn 2 (s1, s3)                 bending
/// s5   = beam 4 (s4)                     bending
/// s6   = free                            translation
/// s7   = mass 7 (s6)                     translation
/// s8   = spring_damper 6 (s7)            translation
/// s9   = conn 5 (s5, s8)                 bending
/// s10  = beam 8 (s9)                     bending
/// s11  = fixed                           rotation
/// s12  = torsion_spring 10 (s11)         rotation
/// s13  = conn 9 (s10, s12)               bending
/// s14  = beam 11 (s13)                   bending
/// s15  = pinned, the root (s14)          bending
/// ```
///
/// # Paths
///
/// ```text
/// pinned -> beam 1 -> conn 2 -> beam 4 -> conn 5 -> beam 8 -> conn 9 -> beam 11 -> pinned, the root
/// fixed -> spring 3 -> conn 2
/// free -> mass 7 -> spring_damper 6 -> conn 5
/// fixed -> torsion_spring 10 -> conn 9
/// ```
#[derive(::core::clone::Clone, ::core::fmt::Debug)]
pub struct DampedOscillatorSystem<T: mstmm::__private::Real = f64> {
    /// `beam 1`
    element_1: <mstmm::__private::elements::Beam<T> as mstmm::__private::Element>::Built,
    /// `spring 3`
    element_3: <mstmm::__private::elements::Spring<
        T,
    > as mstmm::__private::Element>::Built,
    /// `beam 4`
    element_4: <mstmm::__private::elements::Beam<T> as mstmm::__private::Element>::Built,
    /// `mass 7`
    element_7: <mstmm::__private::elements::Mass<T> as mstmm::__private::Element>::Built,
    /// `spring_damper 6`
    element_6: <mstmm::__private::elements::SpringDamper<
        T,
    > as mstmm::__private::Element>::Built,
    /// `beam 8`
    element_8: <mstmm::__private::elements::Beam<T> as mstmm::__private::Element>::Built,
    /// `torsion_spring 10`
    element_10: <mstmm::__private::elements::TorsionSpring<
        T,
    > as mstmm::__private::Element>::Built,
    /// `beam 11`
    element_11: <mstmm::__private::elements::Beam<
        T,
    > as mstmm::__private::Element>::Built,
    /// The field `length`
    field_length: ::core::primitive::f64,
    /// The field `bending_stiffness`
    field_bending_stiffness: ::core::primitive::f64,
    /// The field `mass_per_length`
    field_mass_per_length: ::core::primitive::f64,
    /// The field `spring_position`
    field_spring_position: ::core::primitive::f64,
    /// The field `oscillator_position`
    field_oscillator_position: ::core::primitive::f64,
    /// The field `torsion_position`
    field_torsion_position: ::core::primitive::f64,
    /// The field `spring_stiffness`
    field_spring_stiffness: ::core::primitive::f64,
    /// The field `oscillator_stiffness`
    field_oscillator_stiffness: ::core::primitive::f64,
    /// The field `damping`
    field_damping: ::core::primitive::f64,
    /// The field `mass`
    field_mass: ::core::primitive::f64,
    /// The field `torsion_stiffness`
    field_torsion_stiffness: ::core::primitive::f64,
    parameter: ::core::marker::PhantomData<T>,
}
impl DampedOscillator {
    /// Validates all parameters and builds the system.
    ///
    /// # Errors
    /// The error names the first element with a parameter out of its range, the parameter and its value.
    pub fn build(
        &self,
    ) -> ::core::result::Result<
        DampedOscillatorSystem,
        mstmm::__private::ParameterError,
    > {
        self.build_as()
    }
    /// Builds the system over another scalar, such as `f32` or the double-double `DoubleDouble`.
    ///
    /// # Errors
    /// As `build`.
    pub fn build_as<T: mstmm::__private::Real>(
        &self,
    ) -> ::core::result::Result<
        DampedOscillatorSystem<T>,
        mstmm::__private::ParameterError,
    > {
        let length = self.length;
        let bending_stiffness = self.bending_stiffness;
        let mass_per_length = self.mass_per_length;
        let spring_position = self.spring_position;
        let oscillator_position = self.oscillator_position;
        let torsion_position = self.torsion_position;
        let spring_stiffness = self.spring_stiffness;
        let oscillator_stiffness = self.oscillator_stiffness;
        let damping = self.damping;
        let mass = self.mass;
        let torsion_stiffness = self.torsion_stiffness;
        let second_span = oscillator_position - spring_position;
        let third_span = torsion_position - oscillator_position;
        let last_span = length - torsion_position;
        ::core::result::Result::Ok(DampedOscillatorSystem {
            element_1: mstmm::__private::build::<
                mstmm::__private::elements::Beam<T>,
            >(
                mstmm::__private::elements::Beam {
                    length: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = spring_position;
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
                mstmm::__private::elements::Spring<T>,
            >(
                mstmm::__private::elements::Spring {
                    stiffness: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = spring_stiffness;
                        number
                    }),
                },
                "spring 3",
            )?,
            element_4: mstmm::__private::build::<
                mstmm::__private::elements::Beam<T>,
            >(
                mstmm::__private::elements::Beam {
                    length: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = second_span;
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
                "beam 4",
            )?,
            element_7: mstmm::__private::build::<
                mstmm::__private::elements::Mass<T>,
            >(
                mstmm::__private::elements::Mass {
                    mass: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = mass;
                        number
                    }),
                },
                "mass 7",
            )?,
            element_6: mstmm::__private::build::<
                mstmm::__private::elements::SpringDamper<T>,
            >(
                mstmm::__private::elements::SpringDamper {
                    stiffness: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = oscillator_stiffness;
                        number
                    }),
                    damping: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = damping;
                        number
                    }),
                },
                "spring_damper 6",
            )?,
            element_8: mstmm::__private::build::<
                mstmm::__private::elements::Beam<T>,
            >(
                mstmm::__private::elements::Beam {
                    length: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = third_span;
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
                "beam 8",
            )?,
            element_10: mstmm::__private::build::<
                mstmm::__private::elements::TorsionSpring<T>,
            >(
                mstmm::__private::elements::TorsionSpring {
                    stiffness: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = torsion_stiffness;
                        number
                    }),
                },
                "torsion_spring 10",
            )?,
            element_11: mstmm::__private::build::<
                mstmm::__private::elements::Beam<T>,
            >(
                mstmm::__private::elements::Beam {
                    length: mstmm::__private::Scalar::from_f64({
                        let number: ::core::primitive::f64 = last_span;
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
                "beam 11",
            )?,
            field_length: self.length,
            field_bending_stiffness: self.bending_stiffness,
            field_mass_per_length: self.mass_per_length,
            field_spring_position: self.spring_position,
            field_oscillator_position: self.oscillator_position,
            field_torsion_position: self.torsion_position,
            field_spring_stiffness: self.spring_stiffness,
            field_oscillator_stiffness: self.oscillator_stiffness,
            field_damping: self.damping,
            field_mass: self.mass,
            field_torsion_stiffness: self.torsion_stiffness,
            parameter: ::core::marker::PhantomData,
        })
    }
}
#[automatically_derived]
impl<T: mstmm::__private::Real> mstmm::__private::System for DampedOscillatorSystem<T> {
    type Parameter = T;
    fn estimates(&self) -> mstmm::__private::FrequencyEstimates {
        let mut estimates = ::core::default::Default::default();
        <mstmm::__private::elements::Beam<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_1, &mut estimates);
        <mstmm::__private::elements::Spring<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_3, &mut estimates);
        <mstmm::__private::elements::Beam<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_4, &mut estimates);
        <mstmm::__private::elements::Mass<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_7, &mut estimates);
        <mstmm::__private::elements::SpringDamper<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_6, &mut estimates);
        <mstmm::__private::elements::Beam<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_8, &mut estimates);
        <mstmm::__private::elements::TorsionSpring<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_10, &mut estimates);
        <mstmm::__private::elements::Beam<
            T,
        > as mstmm::__private::Element>::estimate(&self.element_11, &mut estimates);
        estimates
    }
}
/// The labels of the sketch: elements and connections, as results about motions take them.
#[allow(dead_code, non_upper_case_globals)]
impl DampedOscillator {
    /// `beam 1`
    pub const beam_1: mstmm::__private::Label<
        DampedOscillator,
        mstmm::__private::elements::Beam<f64>,
    > = mstmm::__private::Label::new(1usize, 0usize);
    /// `spring 3`
    pub const spring_3: mstmm::__private::Label<
        DampedOscillator,
        mstmm::__private::elements::Spring<f64>,
    > = mstmm::__private::Label::new(3usize, 2usize);
    /// `conn 2`
    pub const conn_2: mstmm::__private::Point<DampedOscillator> = mstmm::__private::Point::connection(
        4usize,
    );
    /// `beam 4`
    pub const beam_4: mstmm::__private::Label<
        DampedOscillator,
        mstmm::__private::elements::Beam<f64>,
    > = mstmm::__private::Label::new(5usize, 4usize);
    /// `mass 7`
    pub const mass_7: mstmm::__private::Label<
        DampedOscillator,
        mstmm::__private::elements::Mass<f64>,
    > = mstmm::__private::Label::new(7usize, 6usize);
    /// `spring_damper 6`
    pub const spring_damper_6: mstmm::__private::Label<
        DampedOscillator,
        mstmm::__private::elements::SpringDamper<f64>,
    > = mstmm::__private::Label::new(8usize, 7usize);
    /// `conn 5`
    pub const conn_5: mstmm::__private::Point<DampedOscillator> = mstmm::__private::Point::connection(
        9usize,
    );
    /// `beam 8`
    pub const beam_8: mstmm::__private::Label<
        DampedOscillator,
        mstmm::__private::elements::Beam<f64>,
    > = mstmm::__private::Label::new(10usize, 9usize);
    /// `torsion_spring 10`
    pub const torsion_spring_10: mstmm::__private::Label<
        DampedOscillator,
        mstmm::__private::elements::TorsionSpring<f64>,
    > = mstmm::__private::Label::new(12usize, 11usize);
    /// `conn 9`
    pub const conn_9: mstmm::__private::Point<DampedOscillator> = mstmm::__private::Point::connection(
        13usize,
    );
    /// `beam 11`
    pub const beam_11: mstmm::__private::Label<
        DampedOscillator,
        mstmm::__private::elements::Beam<f64>,
    > = mstmm::__private::Label::new(14usize, 13usize);
}
#[automatically_derived]
impl<T: mstmm::__private::Real> mstmm::__private::Fields for DampedOscillatorSystem<T> {
    const NAMES: &'static [&'static ::core::primitive::str] = &[
        "length",
        "bending_stiffness",
        "mass_per_length",
        "spring_position",
        "oscillator_position",
        "torsion_position",
        "spring_stiffness",
        "oscillator_stiffness",
        "damping",
        "mass",
        "torsion_stiffness",
    ];
    type PerField<V: ::core::marker::Copy + ::core::fmt::Debug> = [V; <[()]>::len(
        &[(), (), (), (), (), (), (), (), (), (), ()],
    )];
    fn per_field<V: ::core::marker::Copy + ::core::fmt::Debug>(
        value: V,
    ) -> Self::PerField<V> {
        [value; _]
    }
}
#[automatically_derived]
impl<T, S> mstmm::__private::Chain<S> for DampedOscillatorSystem<T>
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
    mstmm::__private::elements::SpringDamper<
        T,
    >: mstmm::__private::Energies<
        S,
        Gradient = mstmm::__private::elements::SpringDamper<S>,
    >,
    mstmm::__private::elements::TorsionSpring<
        T,
    >: mstmm::__private::Energies<
        S,
        Gradient = mstmm::__private::elements::TorsionSpring<S>,
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
        let spring_position = chain.variable(self.field_spring_position);
        let oscillator_position = chain.variable(self.field_oscillator_position);
        let torsion_position = chain.variable(self.field_torsion_position);
        let spring_stiffness = chain.variable(self.field_spring_stiffness);
        let oscillator_stiffness = chain.variable(self.field_oscillator_stiffness);
        let damping = chain.variable(self.field_damping);
        let mass = chain.variable(self.field_mass);
        let torsion_stiffness = chain.variable(self.field_torsion_stiffness);
        let second_span = oscillator_position - spring_position;
        let third_span = torsion_position - oscillator_position;
        let last_span = length - torsion_position;
        let values = (spring_position, bending_stiffness, mass_per_length);
        for step in [1usize] {
            let gradient = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_1, &ends(step));
            chain.add(gradient.length, values.0);
            chain.add(gradient.bending_stiffness, values.1);
            chain.add(gradient.mass_per_length, values.2);
        }
        let values = (spring_stiffness,);
        for step in [3usize] {
            let gradient = <mstmm::__private::elements::Spring<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_3, &ends(step));
            chain.add(gradient.stiffness, values.0);
        }
        let values = (second_span, bending_stiffness, mass_per_length);
        for step in [5usize] {
            let gradient = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_4, &ends(step));
            chain.add(gradient.length, values.0);
            chain.add(gradient.bending_stiffness, values.1);
            chain.add(gradient.mass_per_length, values.2);
        }
        let values = (mass,);
        for step in [7usize] {
            let gradient = <mstmm::__private::elements::Mass<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_7, &ends(step));
            chain.add(gradient.mass, values.0);
        }
        let values = (oscillator_stiffness, damping);
        for step in [8usize] {
            let gradient = <mstmm::__private::elements::SpringDamper<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_6, &ends(step));
            chain.add(gradient.stiffness, values.0);
            chain.add(gradient.damping, values.1);
        }
        let values = (third_span, bending_stiffness, mass_per_length);
        for step in [10usize] {
            let gradient = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_8, &ends(step));
            chain.add(gradient.length, values.0);
            chain.add(gradient.bending_stiffness, values.1);
            chain.add(gradient.mass_per_length, values.2);
        }
        let values = (torsion_stiffness,);
        for step in [12usize] {
            let gradient = <mstmm::__private::elements::TorsionSpring<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_10, &ends(step));
            chain.add(gradient.stiffness, values.0);
        }
        let values = (last_span, bending_stiffness, mass_per_length);
        for step in [14usize] {
            let gradient = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::Energies<S>>::gradient(&self.element_11, &ends(step));
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
            mstmm::__private::Step::Tip(mstmm::__private::Support::Fixed),
            mstmm::__private::Step::Element(
                2usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Spring<f64>>(),
            ),
            mstmm::__private::Step::Connection(&[1usize, 3usize]),
            mstmm::__private::Step::Element(
                4usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Beam<f64>>(),
            ),
            mstmm::__private::Step::Tip(mstmm::__private::Support::Free),
            mstmm::__private::Step::Element(
                6usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Mass<f64>>(),
            ),
            mstmm::__private::Step::Element(
                7usize,
                mstmm::__private::space_of::<
                    mstmm::__private::elements::SpringDamper<f64>,
                >(),
            ),
            mstmm::__private::Step::Connection(&[5usize, 8usize]),
            mstmm::__private::Step::Element(
                9usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Beam<f64>>(),
            ),
            mstmm::__private::Step::Tip(mstmm::__private::Support::Fixed),
            mstmm::__private::Step::Element(
                11usize,
                mstmm::__private::space_of::<
                    mstmm::__private::elements::TorsionSpring<f64>,
                >(),
            ),
            mstmm::__private::Step::Connection(&[10usize, 12usize]),
            mstmm::__private::Step::Element(
                13usize,
                mstmm::__private::space_of::<mstmm::__private::elements::Beam<f64>>(),
            ),
            mstmm::__private::Step::Root(14usize, mstmm::__private::Support::Pinned),
        ])
    }
        .scheme();
    const _: () = LAYOUT.check_support(0usize);
    const _: () = LAYOUT.check_arrow(1usize);
    const _: () = LAYOUT.check_support(2usize);
    const _: () = LAYOUT.check_arrow(3usize);
    const _: () = LAYOUT.check_connection(4usize);
    const _: () = LAYOUT.check_arrow(5usize);
    const _: () = LAYOUT.check_support(6usize);
    const _: () = LAYOUT.check_arrow(7usize);
    const _: () = LAYOUT.check_arrow(8usize);
    const _: () = LAYOUT.check_connection(9usize);
    const _: () = LAYOUT.check_arrow(10usize);
    const _: () = LAYOUT.check_support(11usize);
    const _: () = LAYOUT.check_arrow(12usize);
    const _: () = LAYOUT.check_connection(13usize);
    const _: () = LAYOUT.check_arrow(14usize);
    const _: () = LAYOUT.check_support(15usize);
    impl DampedOscillatorSystem {
        /// Width of the reduced overall matrix: the number of unknowns at the boundaries.
        pub const N: usize = 7;
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Evaluate<S> for DampedOscillatorSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::TransferMatrix<S>,
        mstmm::__private::elements::Mass<T>: mstmm::__private::TransferMatrix<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::TransferMatrix<S>,
        mstmm::__private::elements::SpringDamper<T>: mstmm::__private::TransferMatrix<S>,
        mstmm::__private::elements::TorsionSpring<
            T,
        >: mstmm::__private::TransferMatrix<S>,
    {
        type Matrix = mstmm::__private::SMatrix<S, 7, 7>;
        fn overall_matrix(&self, x: S) -> Self::Matrix {
            let u_1 = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_1, x);
            let u_3 = <mstmm::__private::elements::Spring<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_3, x);
            let u_4 = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_4, x);
            let u_7 = <mstmm::__private::elements::Mass<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_7, x);
            let u_6 = <mstmm::__private::elements::SpringDamper<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_6, x);
            let u_8 = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_8, x);
            let u_10 = <mstmm::__private::elements::TorsionSpring<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_10, x);
            let u_11 = <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::TransferMatrix<
                S,
            >>::transfer_matrix(&self.element_11, x);
            let mut equation = mstmm::__private::Assembly::new(LAYOUT);
            equation.element::<mstmm::__private::elements::Beam<T>>(1usize, &u_1);
            equation.element::<mstmm::__private::elements::Spring<T>>(3usize, &u_3);
            equation.connection(4usize);
            equation.element::<mstmm::__private::elements::Beam<T>>(5usize, &u_4);
            equation.element::<mstmm::__private::elements::Mass<T>>(7usize, &u_7);
            equation
                .element::<mstmm::__private::elements::SpringDamper<T>>(8usize, &u_6);
            equation.connection(9usize);
            equation.element::<mstmm::__private::elements::Beam<T>>(10usize, &u_8);
            equation
                .element::<mstmm::__private::elements::TorsionSpring<T>>(12usize, &u_10);
            equation.connection(13usize);
            equation.element::<mstmm::__private::elements::Beam<T>>(14usize, &u_11);
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
                mstmm::__private::elements::Spring<T>,
                S,
            >(determinant, &self.element_3, x);
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::Beam<T>,
                S,
            >(determinant, &self.element_4, x);
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::Mass<T>,
                S,
            >(determinant, &self.element_7, x);
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::SpringDamper<T>,
                S,
            >(determinant, &self.element_6, x);
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::Beam<T>,
                S,
            >(determinant, &self.element_8, x);
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::TorsionSpring<T>,
                S,
            >(determinant, &self.element_10, x);
            let determinant = mstmm::__private::without_pole::<
                mstmm::__private::elements::Beam<T>,
                S,
            >(determinant, &self.element_11, x);
            determinant
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Characteristic<S> for DampedOscillatorSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Mass<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::SpringDamper<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::TorsionSpring<T>: mstmm::__private::PlaneStep<S>,
    {
        #[inline]
        fn pass<C: mstmm::__private::RootCounter<S>>(
            &self,
            x: S,
            counter: &mut C,
        ) -> mstmm::__private::Scaled<S> {
            const STEPS: usize = 16usize;
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
                    > as mstmm::__private::PlaneStep<S>>::WAVES
                    || <mstmm::__private::elements::SpringDamper<
                        T,
                    > as mstmm::__private::PlaneStep<S>>::WAVES
                    || <mstmm::__private::elements::TorsionSpring<
                        T,
                    > as mstmm::__private::PlaneStep<S>>::WAVES,
            );
            let k_1 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Beam<T>,
                S,
                STEPS,
            >(&self.element_1, &at);
            let k_3 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Spring<T>,
                S,
                STEPS,
            >(&self.element_3, &at);
            let k_4 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Beam<T>,
                S,
                STEPS,
            >(&self.element_4, &at);
            let k_7 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Mass<T>,
                S,
                STEPS,
            >(&self.element_7, &at);
            let k_6 = mstmm::__private::coefficients::<
                mstmm::__private::elements::SpringDamper<T>,
                S,
                STEPS,
            >(&self.element_6, &at);
            let k_8 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Beam<T>,
                S,
                STEPS,
            >(&self.element_8, &at);
            let k_10 = mstmm::__private::coefficients::<
                mstmm::__private::elements::TorsionSpring<T>,
                S,
                STEPS,
            >(&self.element_10, &at);
            let k_11 = mstmm::__private::coefficients::<
                mstmm::__private::elements::Beam<T>,
                S,
                STEPS,
            >(&self.element_11, &at);
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
            let s2 = mstmm::__private::Subspace::Tip(
                mstmm::__private::Support::Fixed,
                const { LAYOUT.space(2usize) },
            );
            let s3 = mstmm::__private::step::<
                mstmm::__private::elements::Spring<T>,
                S,
                C,
                STEPS,
            >(&k_3, s2, counter);
            let s4 = s1;
            let s4 = mstmm::__private::join::<S, C, true, STEPS>(s4, s3, counter);
            let s4 = mstmm::__private::widened(s4, const { LAYOUT.output(4usize) });
            let s4 = mstmm::__private::narrowed(
                s4,
                const { LAYOUT.output(4usize) },
                counter,
            );
            let s5 = mstmm::__private::step::<
                mstmm::__private::elements::Beam<T>,
                S,
                C,
                STEPS,
            >(&k_4, s4, counter);
            let s6 = mstmm::__private::Subspace::Tip(
                mstmm::__private::Support::Free,
                const { LAYOUT.space(6usize) },
            );
            let s7 = mstmm::__private::step::<
                mstmm::__private::elements::Mass<T>,
                S,
                C,
                STEPS,
            >(&k_7, s6, counter);
            let s8 = mstmm::__private::step::<
                mstmm::__private::elements::SpringDamper<T>,
                S,
                C,
                STEPS,
            >(&k_6, s7, counter);
            let s9 = s5;
            let s9 = mstmm::__private::join::<S, C, true, STEPS>(s9, s8, counter);
            let s9 = mstmm::__private::widened(s9, const { LAYOUT.output(9usize) });
            let s9 = mstmm::__private::narrowed(
                s9,
                const { LAYOUT.output(9usize) },
                counter,
            );
            let s10 = mstmm::__private::step::<
                mstmm::__private::elements::Beam<T>,
                S,
                C,
                STEPS,
            >(&k_8, s9, counter);
            let s11 = mstmm::__private::Subspace::Tip(
                mstmm::__private::Support::Fixed,
                const { LAYOUT.space(11usize) },
            );
            let s12 = mstmm::__private::step::<
                mstmm::__private::elements::TorsionSpring<T>,
                S,
                C,
                STEPS,
            >(&k_10, s11, counter);
            let s13 = s10;
            let s13 = mstmm::__private::join::<S, C, true, STEPS>(s13, s12, counter);
            let s13 = mstmm::__private::widened(s13, const { LAYOUT.output(13usize) });
            let s13 = mstmm::__private::narrowed(
                s13,
                const { LAYOUT.output(13usize) },
                counter,
            );
            mstmm::__private::root::<
                mstmm::__private::elements::Beam<T>,
                S,
                C,
                STEPS,
            >(&k_11, s13, mstmm::__private::Support::Pinned, counter)
        }
    }
    #[automatically_derived]
    impl<T: mstmm::__private::Real> mstmm::__private::Planned
    for DampedOscillatorSystem<T> {
        type Model = DampedOscillator;
        type PerStep<C: ::core::marker::Copy + ::core::fmt::Debug> = [C; 16usize];
        fn per_step<C: ::core::marker::Copy + ::core::fmt::Debug>(
            value: C,
        ) -> [C; 16usize] {
            [value; 16usize]
        }
        fn scheme() -> mstmm::__private::Scheme<'static> {
            LAYOUT
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Tree<S> for DampedOscillatorSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::Mass<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::SpringDamper<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::TorsionSpring<T>: mstmm::__private::Energies<S>,
    {
        type Evaluated = (
            <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
            <mstmm::__private::elements::Spring<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
            <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
            <mstmm::__private::elements::Mass<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
            <mstmm::__private::elements::SpringDamper<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
            <mstmm::__private::elements::Beam<
                T,
            > as mstmm::__private::PlaneStep<S>>::Coefficients,
            <mstmm::__private::elements::TorsionSpring<
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
                    > as mstmm::__private::PlaneStep<S>>::WAVES
                    || <mstmm::__private::elements::SpringDamper<
                        T,
                    > as mstmm::__private::PlaneStep<S>>::WAVES
                    || <mstmm::__private::elements::TorsionSpring<
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
                <mstmm::__private::elements::Spring<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_3, at),
                <mstmm::__private::elements::Beam<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_4, at),
                <mstmm::__private::elements::Mass<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_7, at),
                <mstmm::__private::elements::SpringDamper<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_6, at),
                <mstmm::__private::elements::Beam<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_8, at),
                <mstmm::__private::elements::TorsionSpring<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_10, at),
                <mstmm::__private::elements::Beam<
                    T,
                > as mstmm::__private::PlaneStep<S>>::coefficients(&self.element_11, at),
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
                    3usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Spring<T>,
                            >(&self.element_3)
                    }
                    5usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Beam<T>,
                            >(&self.element_4)
                    }
                    7usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Mass<T>,
                            >(&self.element_7)
                    }
                    8usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::SpringDamper<T>,
                            >(&self.element_6)
                    }
                    10usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Beam<T>,
                            >(&self.element_8)
                    }
                    12usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::TorsionSpring<T>,
                            >(&self.element_10)
                    }
                    14usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Beam<T>,
                            >(&self.element_11)
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
                    3usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Spring<T>,
                            >(&self.element_3, &evaluated.1)
                    }
                    5usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Beam<T>,
                            >(&self.element_4, &evaluated.2)
                    }
                    7usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Mass<T>,
                            >(&self.element_7, &evaluated.3)
                    }
                    8usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::SpringDamper<T>,
                            >(&self.element_6, &evaluated.4)
                    }
                    10usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Beam<T>,
                            >(&self.element_8, &evaluated.5)
                    }
                    12usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::TorsionSpring<T>,
                            >(&self.element_10, &evaluated.6)
                    }
                    14usize => {
                        visitor
                            .element::<
                                mstmm::__private::elements::Beam<T>,
                            >(&self.element_11, &evaluated.7)
                    }
                    _ => return ::core::option::Option::None,
                },
            )
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::TreeInBlocks<S> for DampedOscillatorSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::Mass<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::SpringDamper<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::TorsionSpring<T>: mstmm::__private::Energies<S>,
        mstmm::__private::elements::Beam<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Mass<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Spring<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::SpringDamper<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::TorsionSpring<
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
        mstmm::__private::elements::SpringDamper<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
        mstmm::__private::elements::TorsionSpring<
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
                3usize => {
                    visitor
                        .element::<
                            mstmm::__private::elements::Spring<T>,
                        >(&self.element_3)
                }
                5usize => {
                    visitor
                        .element::<mstmm::__private::elements::Beam<T>>(&self.element_4)
                }
                7usize => {
                    visitor
                        .element::<mstmm::__private::elements::Mass<T>>(&self.element_7)
                }
                8usize => {
                    visitor
                        .element::<
                            mstmm::__private::elements::SpringDamper<T>,
                        >(&self.element_6)
                }
                10usize => {
                    visitor
                        .element::<mstmm::__private::elements::Beam<T>>(&self.element_8)
                }
                12usize => {
                    visitor
                        .element::<
                            mstmm::__private::elements::TorsionSpring<T>,
                        >(&self.element_10)
                }
                14usize => {
                    visitor
                        .element::<mstmm::__private::elements::Beam<T>>(&self.element_11)
                }
                _ => {}
            }
        }
    }
    #[automatically_derived]
    impl<T, S> mstmm::__private::Walk<S> for DampedOscillatorSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::Beam<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Mass<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::SpringDamper<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::TorsionSpring<T>: mstmm::__private::PlaneStep<S>,
        mstmm::__private::elements::Beam<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Mass<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::Spring<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::SpringDamper<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, false>>,
        mstmm::__private::elements::TorsionSpring<
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
        mstmm::__private::elements::SpringDamper<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
        mstmm::__private::elements::TorsionSpring<
            T,
        >: mstmm::__private::PlaneStep<mstmm::__private::BranchFree<S, true>>,
    {
        fn walk<C: mstmm::__private::Walker<S>>(&self, walker: &mut C) {
            walker
                .tip(mstmm::__private::Support::Pinned, const { LAYOUT.space(0usize) });
            walker.element::<mstmm::__private::elements::Beam<T>>(&self.element_1);
            walker.tip(mstmm::__private::Support::Fixed, const { LAYOUT.space(2usize) });
            walker.element::<mstmm::__private::elements::Spring<T>>(&self.element_3);
            walker.connection(&[1, 0], const { LAYOUT.output(4usize) });
            walker.element::<mstmm::__private::elements::Beam<T>>(&self.element_4);
            walker.tip(mstmm::__private::Support::Free, const { LAYOUT.space(6usize) });
            walker.element::<mstmm::__private::elements::Mass<T>>(&self.element_7);
            walker
                .element::<mstmm::__private::elements::SpringDamper<T>>(&self.element_6);
            walker.connection(&[1, 0], const { LAYOUT.output(9usize) });
            walker.element::<mstmm::__private::elements::Beam<T>>(&self.element_8);
            walker
                .tip(mstmm::__private::Support::Fixed, const { LAYOUT.space(11usize) });
            walker
                .element::<
                    mstmm::__private::elements::TorsionSpring<T>,
                >(&self.element_10);
            walker.connection(&[1, 0], const { LAYOUT.output(13usize) });
            walker.element::<mstmm::__private::elements::Beam<T>>(&self.element_11);
            walker.root(mstmm::__private::Support::Pinned);
        }
    }
};
