/// A mast with a guy, and a lamp at its top.
#[derive(Debug)]
pub struct Mast {
    /// Height [m].
    pub height: f64,
    /// Stiffness of the guy [N/m].
    pub stiffness: f64,
    /// Mass of the lamp [kg].
    pub lamp: f64,
}
/// The built system of [`Mast`]: evaluate it at a frequency, or search its frequencies.
///
/// # Size
///
/// ```text
/// nodes 3, members 2, unknowns at once 7
/// closed loops 0
/// unknowns of the overall transfer equation 8, root fixed at beam 1
/// ```
///
/// # Nodes
///
/// In the order of their elimination, with the motions that supports leave, the members that begin there,
/// and the number of variables that are left behind each. Points at rest leave with their members.
///
/// ```text
/// conn top          x y rz     0   beam 1, spring guy
/// ```
#[derive(::core::clone::Clone, ::core::fmt::Debug)]
pub struct MastSystem<T: mstmm::__private::Parameter = f64> {
    skeleton: mstmm::__private::Skeleton<T, 3usize, 2usize>,
    /// `beam 1`
    member_0: <mstmm::__private::elements::InPlane<
        mstmm::__private::elements::Beam<T>,
    > as mstmm::__private::Element>::Built,
    /// `spring guy`
    member_1: <mstmm::__private::elements::Spring<
        T,
    > as mstmm::__private::Element>::Built,
    /// The field `height`
    field_height: ::core::primitive::f64,
    /// The field `stiffness`
    field_stiffness: ::core::primitive::f64,
    /// The field `lamp`
    field_lamp: ::core::primitive::f64,
    /// The numbers of places, directions and masses
    geometry: [::core::primitive::f64; 10usize],
    estimates: mstmm::__private::FrequencyEstimates,
}
impl mstmm::__private::Numbered for Mast {
    type Numbers = [::core::primitive::f64; 14usize];
    fn numbers(&self) -> [::core::primitive::f64; 14usize] {
        let height = self.height;
        let stiffness = self.stiffness;
        let lamp = self.lamp;
        [
            {
                let number: ::core::primitive::f64 = 0.0;
                number
            },
            {
                let number: ::core::primitive::f64 = 0.0;
                number
            },
            {
                let number: ::core::primitive::f64 = 0.0;
                number
            },
            {
                let number: ::core::primitive::f64 = height;
                number
            },
            {
                let number: ::core::primitive::f64 = 0.5 * height;
                number
            },
            {
                let number: ::core::primitive::f64 = 0.0;
                number
            },
            {
                let number: ::core::primitive::f64 = lamp;
                number
            },
            0.0,
            {
                let number: ::core::primitive::f64 = 0.0;
                number
            },
            {
                let number: ::core::primitive::f64 = height;
                number
            },
            {
                let number: ::core::primitive::f64 = 1e6;
                number
            },
            {
                let number: ::core::primitive::f64 = 500.0;
                number
            },
            {
                let number: ::core::primitive::f64 = 2.0;
                number
            },
            {
                let number: ::core::primitive::f64 = stiffness;
                number
            },
        ]
    }
}
#[automatically_derived]
impl mstmm::__private::Formulas for Mast {
    type Built = MastSystem;
    const COMPARES: ::core::primitive::bool = false;
    #[inline]
    fn values(
        &self,
    ) -> <MastSystem as mstmm::__private::Fields>::PerField<::core::primitive::f64> {
        [self.height, self.stiffness, self.lamp]
    }
    #[inline]
    fn built(
        &self,
        numbers: &Self::Numbers,
    ) -> ::core::result::Result<MastSystem, mstmm::__private::ParameterError> {
        mstmm::__private::Build::build_of(self, numbers)
    }
    #[inline]
    #[allow(unused_braces)]
    fn enclose(
        &self,
        fields: &<MastSystem as mstmm::__private::Fields>::PerField<
            mstmm::__private::Interval,
        >,
        take: &mut dyn ::core::ops::FnMut(
            ::core::primitive::usize,
            mstmm::__private::Interval,
            &[mstmm::__private::Interval],
        ),
    ) {
        let mut chain = mstmm::__private::Enclosing::new(fields);
        let height = chain.variable();
        let stiffness = chain.variable();
        let lamp = chain.variable();
        let number = height;
        take(3usize, number.value, &number.partials);
        let number = 0.5 * height;
        take(4usize, number.value, &number.partials);
        let number = lamp;
        take(6usize, number.value, &number.partials);
        let number = height;
        take(9usize, number.value, &number.partials);
        let number = stiffness;
        take(13usize, number.value, &number.partials);
    }
}
const _: () = {
    const _: () = {
        #[allow(dead_code, non_snake_case)]
        struct Labels {
            /// `conn top`
            top: (),
            /// `conn anchor`
            anchor: (),
        }
        const _: fn(&Labels) = |labels| {
            let _ = labels.top;
            let _ = labels.top;
            let _ = labels.anchor;
            let _ = labels.top;
        };
    };
    const _: () = {
        #[allow(dead_code, non_snake_case)]
        struct Labels {
            /// `spring guy`
            guy: (),
        }
        const _: fn(&Labels) = |labels| {
            let _ = labels.guy;
        };
    };
    /// The labels of the sketch: points and members, as results about motions take them.
    #[allow(dead_code, non_upper_case_globals)]
    impl Mast {
        /// `conn top`
        pub const conn_top: mstmm::__private::PlanePoint<Mast> = SKETCH.label(1usize);
        /// `conn anchor`
        pub const conn_anchor: mstmm::__private::PlanePoint<Mast> = SKETCH.label(2usize);
        /// `beam 1`
        pub const beam_1: mstmm::__private::MemberLabel<
            Mast,
            mstmm::__private::elements::InPlane<mstmm::__private::elements::Beam<f64>>,
        > = mstmm::__private::MemberLabel::member(0usize);
        /// `spring guy`
        pub const spring_guy: mstmm::__private::MemberLabel<
            Mast,
            mstmm::__private::elements::Spring<f64>,
        > = mstmm::__private::MemberLabel::member(1usize);
    }
    const SKETCH: mstmm::__private::NetworkSketch<3usize, 2usize> = mstmm::__private::NetworkSketch {
        is_in_space: false,
        places: &["fixed at beam 1", "conn top", "conn anchor"],
        directions: &[],
        bodies: &[
            mstmm::__private::SketchedBody {
                name: "point_mass 3",
                node: 1usize,
            },
        ],
        points: &[
            mstmm::__private::SketchedPoint {
                name: "fixed at beam 1",
                node: 0usize,
                place: 0usize,
                freedoms: mstmm::__private::Freedoms::PLANE,
            },
            mstmm::__private::SketchedPoint {
                name: "conn top",
                node: 1usize,
                place: 1usize,
                freedoms: mstmm::__private::Freedoms::PLANE,
            },
            mstmm::__private::SketchedPoint {
                name: "conn anchor",
                node: 2usize,
                place: 2usize,
                freedoms: mstmm::__private::Freedoms::NONE
                    .union(mstmm::__private::Freedoms::X)
                    .union(mstmm::__private::Freedoms::Y),
            },
        ],
        supports: &[
            mstmm::__private::SketchedSupport {
                name: "fixed at beam 1",
                point: 0usize,
                node: 0usize,
                held: mstmm::__private::Freedoms::PLANE,
                skew: ::core::option::Option::None,
            },
            mstmm::__private::SketchedSupport {
                name: "fixed at conn anchor",
                point: 2usize,
                node: 2usize,
                held: mstmm::__private::Freedoms::NONE
                    .union(mstmm::__private::Freedoms::X)
                    .union(mstmm::__private::Freedoms::Y),
                skew: ::core::option::Option::None,
            },
        ],
        nodes: [
            mstmm::__private::SketchedNode {
                place: ::core::option::Option::Some(0usize),
                freedoms: mstmm::__private::Freedoms::PLANE,
                held: mstmm::__private::Freedoms::PLANE,
                skew: ::core::option::Option::None,
            },
            mstmm::__private::SketchedNode {
                place: ::core::option::Option::Some(1usize),
                freedoms: mstmm::__private::Freedoms::PLANE,
                held: mstmm::__private::Freedoms::NONE,
                skew: ::core::option::Option::None,
            },
            mstmm::__private::SketchedNode {
                place: ::core::option::Option::Some(2usize),
                freedoms: mstmm::__private::Freedoms::NONE
                    .union(mstmm::__private::Freedoms::X)
                    .union(mstmm::__private::Freedoms::Y),
                held: mstmm::__private::Freedoms::PLANE,
                skew: ::core::option::Option::None,
            },
        ],
        members: [
            mstmm::__private::SketchedMember {
                name: "beam 1",
                kind: ::core::option::Option::Some("Beam"),
                freedoms: mstmm::__private::Freedoms::PLANE,
                released: mstmm::__private::Freedoms::NONE,
                plane: mstmm::__private::SketchedPlane::Structure,
                is_further: false,
                ends: [
                    mstmm::__private::SketchedEnd {
                        seat: mstmm::__private::Seat::Point(0usize),
                        axis: mstmm::__private::Axis::Member,
                    },
                    mstmm::__private::SketchedEnd {
                        seat: mstmm::__private::Seat::Point(1usize),
                        axis: mstmm::__private::Axis::Member,
                    },
                ],
            },
            mstmm::__private::SketchedMember {
                name: "spring guy",
                kind: ::core::option::Option::Some("Spring"),
                freedoms: mstmm::__private::Freedoms::NONE
                    .union(mstmm::__private::Freedoms::X),
                released: mstmm::__private::Freedoms::NONE,
                plane: mstmm::__private::SketchedPlane::Structure,
                is_further: false,
                ends: [
                    mstmm::__private::SketchedEnd {
                        seat: mstmm::__private::Seat::Point(1usize),
                        axis: mstmm::__private::Axis::Member,
                    },
                    mstmm::__private::SketchedEnd {
                        seat: mstmm::__private::Seat::Point(2usize),
                        axis: mstmm::__private::Axis::Member,
                    },
                ],
            },
        ],
    };
    #[allow(long_running_const_eval)]
    const ORDER: &mstmm::__private::OrderRoom<3usize, 2usize> = &mstmm::__private::OrderRoom::of(
        SKETCH.pairs(),
    );
    #[automatically_derived]
    impl mstmm::__private::Build for Mast {
        type System<T: mstmm::__private::Parameter> = MastSystem<T>;
        fn build_of<T: mstmm::__private::Real>(
            &self,
            numbers: &Self::Numbers,
        ) -> ::core::result::Result<MastSystem<T>, mstmm::__private::ParameterError> {
            let number = |k: ::core::primitive::usize| <T as mstmm::__private::Scalar>::from_f64(
                numbers[k],
            );
            let skeleton = mstmm::__private::Skeleton::new(&SKETCH, numbers)?;
            let mut system = MastSystem {
                member_0: mstmm::__private::build_member::<
                    mstmm::__private::elements::InPlane<
                        mstmm::__private::elements::Beam<T>,
                    >,
                >(
                    mstmm::__private::elements::InPlane {
                        axial_stiffness: number(10usize),
                        across: mstmm::__private::elements::Beam {
                            length: skeleton.length(0usize),
                            bending_stiffness: number(11usize),
                            mass_per_length: number(12usize),
                        },
                    },
                    "beam 1",
                )?,
                member_1: mstmm::__private::build_member::<
                    mstmm::__private::elements::Spring<T>,
                >(
                    mstmm::__private::elements::Spring {
                        stiffness: number(13usize),
                    },
                    "spring guy",
                )?,
                field_height: self.height,
                field_stiffness: self.stiffness,
                field_lamp: self.lamp,
                geometry: ::core::array::from_fn(|k: ::core::primitive::usize| {
                    numbers[k]
                }),
                skeleton,
                estimates: ::core::default::Default::default(),
            };
            mstmm::__private::Prestressed::describe(&mut system);
            ::core::result::Result::Ok(system)
        }
    }
    impl Mast {
        /// Validates all places and parameters and builds the system.
        ///
        /// # Errors
        /// The error names the first place or element with a number out of its range, and the number.
        pub fn build(
            &self,
        ) -> ::core::result::Result<MastSystem, mstmm::__private::ParameterError> {
            self.build_as()
        }
        /// Builds the system over another scalar, such as `f32` or the double-double `DoubleDouble`.
        ///
        /// # Errors
        /// As `build`.
        pub fn build_as<T: mstmm::__private::Real>(
            &self,
        ) -> ::core::result::Result<MastSystem<T>, mstmm::__private::ParameterError> {
            mstmm::__private::Build::build_of(
                self,
                &mstmm::__private::Numbered::numbers(self),
            )
        }
    }
    #[automatically_derived]
    impl<T: mstmm::__private::Real> mstmm::__private::System for MastSystem<T> {
        type Parameter = T;
        const HAS_PHASES: bool = false;
        const IS_NETWORK: bool = true;
        const MAY_BUCKLE: bool = <mstmm::__private::elements::InPlane<
            mstmm::__private::elements::Beam<T>,
        > as mstmm::__private::Element>::MAY_BUCKLE
            || <mstmm::__private::elements::Spring<
                T,
            > as mstmm::__private::Element>::MAY_BUCKLE;
        fn in_numbers(
            &self,
        ) -> ::core::option::Option<mstmm::__private::StiffnessModel<'_>> {
            self.skeleton.in_numbers(&mstmm::__private::Placed::order(self))
        }
        fn name_parts(&self, visitor: &mut dyn mstmm::__private::Visitor) {
            mstmm::__private::visit_network(self, visitor);
        }
        fn spot_of(&self, place: ::core::primitive::usize) -> mstmm::__private::Spot {
            mstmm::__private::Placed::spot(self, place)
        }
        fn spot_of_member(
            &self,
            member: ::core::primitive::usize,
        ) -> mstmm::__private::Spot {
            mstmm::__private::Spot::Named(SKETCH.members[member].name)
        }
        fn frequency_estimates(&self) -> mstmm::__private::FrequencyEstimates {
            self.estimates
        }
    }
    #[automatically_derived]
    impl<T: mstmm::__private::Real> mstmm::__private::Prestressed for MastSystem<T> {
        fn add_axial_force(
            &mut self,
            member: ::core::primitive::usize,
            force: [::core::primitive::f64; 2],
        ) -> ::core::option::Option<
            ::core::result::Result<
                ::core::primitive::bool,
                mstmm::__private::InvalidParameter,
            >,
        > {
            let built = match member {
                0usize => ::core::option::Option::Some(&mut self.member_0),
                _ => ::core::option::Option::None,
            };
            if let ::core::option::Option::Some(built) = built {
                return ::core::option::Option::Some(
                    <mstmm::__private::elements::InPlane<
                        mstmm::__private::elements::Beam<T>,
                    > as mstmm::__private::Element>::add_axial_force(built, force),
                );
            }
            let built = match member {
                1usize => ::core::option::Option::Some(&mut self.member_1),
                _ => ::core::option::Option::None,
            };
            if let ::core::option::Option::Some(built) = built {
                return ::core::option::Option::Some(
                    <mstmm::__private::elements::Spring<
                        T,
                    > as mstmm::__private::Element>::add_axial_force(built, force),
                );
            }
            ::core::option::Option::None
        }
        fn describe(&mut self) {
            self.estimates = ::core::default::Default::default();
            self.skeleton.estimate(&mut self.estimates);
            self.skeleton
                .describe::<
                    mstmm::__private::elements::InPlane<
                        mstmm::__private::elements::Beam<T>,
                    >,
                >(0usize, &self.member_0, &mut self.estimates);
            self.skeleton
                .describe::<
                    mstmm::__private::elements::Spring<T>,
                >(1usize, &self.member_1, &mut self.estimates);
            self.estimates.finish();
            self.skeleton.arrange(&ORDER.order());
        }
        fn name_of_member(
            &self,
            member: ::core::primitive::usize,
        ) -> &'static ::core::primitive::str {
            SKETCH.members[member].name
        }
    }
    #[automatically_derived]
    impl<T: mstmm::__private::Real> mstmm::__private::Placed for MastSystem<T> {
        type Model = Mast;
        type Memory = mstmm::__private::Arrays<7usize, 3usize, 2usize>;
        fn sizes(&self) -> [::core::primitive::usize; 2] {
            [3usize, 2usize]
        }
        fn place(&self, place: ::core::primitive::usize) -> [T; 3] {
            SKETCH.place(&self.geometry, place)
        }
        fn node(
            &self,
            node: ::core::primitive::usize,
        ) -> (&mstmm::__private::PlacedNode<T>, &mstmm::__private::Motions<T>) {
            self.skeleton.node(node)
        }
        fn placement(
            &self,
            member: ::core::primitive::usize,
        ) -> &mstmm::__private::Placement<T> {
            self.skeleton.placement(member)
        }
        fn numbers(&self) -> &[mstmm::__private::MemberNumbers] {
            self.skeleton.numbers()
        }
        fn spot(&self, node: ::core::primitive::usize) -> mstmm::__private::Spot {
            SKETCH.spot(node)
        }
        fn order(&self) -> mstmm::__private::NetworkOrder<'_> {
            ORDER.order()
        }
    }
    #[automatically_derived]
    impl<T: mstmm::__private::Real> mstmm::__private::Drawn for MastSystem<T> {
        const IS_IN_SPACE: ::core::primitive::bool = SKETCH.is_in_space;
        fn points(
            &self,
        ) -> impl ::core::iter::Iterator<Item = mstmm::__private::DrawnPoint<Mast, T>> {
            SKETCH.drawn_points(&self.geometry)
        }
        fn members(
            &self,
        ) -> impl ::core::iter::Iterator<Item = mstmm::__private::DrawnMember<Mast, T>> {
            SKETCH.drawn_members(self)
        }
        fn bodies(
            &self,
        ) -> impl ::core::iter::Iterator<Item = mstmm::__private::DrawnBody<T>> {
            SKETCH.drawn_bodies(&self.geometry)
        }
        fn supports(
            &self,
        ) -> impl ::core::iter::Iterator<Item = mstmm::__private::DrawnSupport<T>> {
            SKETCH.drawn_supports(&self.geometry)
        }
    }
    #[automatically_derived]
    #[allow(unused_braces)]
    impl<T, S> mstmm::__private::PlacedCharts<S> for MastSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::InPlane<
            mstmm::__private::elements::Beam<T>,
        >: mstmm::__private::Charted<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::Charted<S>,
    {
        fn chart(
            &self,
            member: ::core::primitive::usize,
            at: &mstmm::__private::FrequencyPowers<S>,
            length: S,
        ) -> ::core::option::Option<mstmm::__private::Chart<S>> {
            let built = match member {
                0usize => ::core::option::Option::Some(&self.member_0),
                _ => ::core::option::Option::None,
            };
            if let ::core::option::Option::Some(built) = built {
                return ::core::option::Option::Some(
                    <mstmm::__private::elements::InPlane<
                        mstmm::__private::elements::Beam<T>,
                    > as mstmm::__private::Charted<S>>::chart(built, at, length),
                );
            }
            let built = match member {
                1usize => ::core::option::Option::Some(&self.member_1),
                _ => ::core::option::Option::None,
            };
            if let ::core::option::Option::Some(built) = built {
                return ::core::option::Option::Some(
                    <mstmm::__private::elements::Spring<
                        T,
                    > as mstmm::__private::Charted<S>>::chart(built, at, length),
                );
            }
            ::core::option::Option::None
        }
    }
    #[automatically_derived]
    #[allow(unused_braces)]
    impl<T, S> mstmm::__private::Characteristic<S> for MastSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::InPlane<
            mstmm::__private::elements::Beam<T>,
        >: mstmm::__private::Charted<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::Charted<S>,
        S: mstmm::__private::StructureScalar,
    {
        fn pass<C: mstmm::__private::RootCounter<S>>(
            &self,
            x: S,
            counter: &mut C,
        ) -> mstmm::__private::Scaled<S> {
            mstmm::__private::network_pass::<Self, S, C>(self, x, counter)
        }
    }
    #[automatically_derived]
    #[allow(unused_braces)]
    impl<T, S> mstmm::__private::PlacedMotions<S> for MastSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::InPlane<
            mstmm::__private::elements::Beam<T>,
        >: mstmm::__private::MemberMotion<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::MemberMotion<S>,
    {
        fn visit_member<V: mstmm::__private::VisitMember<S>>(
            &self,
            member: ::core::primitive::usize,
            visitor: V,
        ) -> ::core::option::Option<V::Output> {
            let built = match member {
                0usize => ::core::option::Option::Some(&self.member_0),
                _ => ::core::option::Option::None,
            };
            if let ::core::option::Option::Some(built) = built {
                return ::core::option::Option::Some(
                    visitor
                        .member::<
                            mstmm::__private::elements::InPlane<
                                mstmm::__private::elements::Beam<T>,
                            >,
                        >(built),
                );
            }
            let built = match member {
                1usize => ::core::option::Option::Some(&self.member_1),
                _ => ::core::option::Option::None,
            };
            if let ::core::option::Option::Some(built) = built {
                return ::core::option::Option::Some(
                    visitor.member::<mstmm::__private::elements::Spring<T>>(built),
                );
            }
            ::core::option::Option::None
        }
    }
    #[allow(long_running_const_eval)]
    const PATHS: &[mstmm::__private::PathNode; 3usize] = &SKETCH.paths();
    impl MastSystem {
        /// Width of the overall matrix: the number of unknowns at the boundaries and at cuts.
        pub const N: usize = 8;
    }
    #[automatically_derived]
    #[allow(unused_braces)]
    impl<T, S> mstmm::__private::PlacedTransfers<S> for MastSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::InPlane<
            mstmm::__private::elements::Beam<T>,
        >: mstmm::__private::TransferMatrix<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::TransferMatrix<S>,
        S: mstmm::__private::Single,
    {
        fn transfer(
            &self,
            member: ::core::primitive::usize,
            x: S,
        ) -> ::core::option::Option<mstmm::__private::MemberTransfer<S>> {
            let built = match member {
                0usize => ::core::option::Option::Some(&self.member_0),
                _ => ::core::option::Option::None,
            };
            if let ::core::option::Option::Some(built) = built {
                return ::core::option::Option::Some(
                    mstmm::__private::member_transfer::<
                        mstmm::__private::elements::InPlane<
                            mstmm::__private::elements::Beam<T>,
                        >,
                        S,
                    >(built, x),
                );
            }
            let built = match member {
                1usize => ::core::option::Option::Some(&self.member_1),
                _ => ::core::option::Option::None,
            };
            if let ::core::option::Option::Some(built) = built {
                return ::core::option::Option::Some(
                    mstmm::__private::member_transfer::<
                        mstmm::__private::elements::Spring<T>,
                        S,
                    >(built, x),
                );
            }
            ::core::option::Option::None
        }
    }
    #[automatically_derived]
    #[allow(unused_braces)]
    impl<T, S> mstmm::__private::Evaluate<S> for MastSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        mstmm::__private::elements::InPlane<
            mstmm::__private::elements::Beam<T>,
        >: mstmm::__private::TransferMatrix<S>,
        mstmm::__private::elements::Spring<T>: mstmm::__private::TransferMatrix<S>,
        S: mstmm::__private::Single,
    {
        type Matrix = mstmm::__private::SMatrix<S, 8, 8>;
        fn overall_matrix(&self, x: S) -> Self::Matrix {
            mstmm::__private::overall_matrix::<8, Self, S>(self, PATHS, x)
        }
        fn overall_determinant(&self, x: S) -> mstmm::__private::Scaled<S> {
            mstmm::__private::overall_determinant::<8, Self, S>(self, PATHS, x)
        }
    }
    #[automatically_derived]
    impl<T: mstmm::__private::Real> mstmm::__private::NamedFields for MastSystem<T> {
        const NAMES: &'static [&'static ::core::primitive::str] = &[
            "height",
            "stiffness",
            "lamp",
        ];
    }
    #[automatically_derived]
    impl<T: mstmm::__private::Real> mstmm::__private::Fields for MastSystem<T> {
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
    impl<T, S> mstmm::__private::PlaneChain<S> for MastSystem<T>
    where
        T: mstmm::__private::Real,
        S: mstmm::__private::Frequency<T>,
        S: mstmm::__private::PlaneFrequency<T>,
        mstmm::__private::elements::InPlane<
            mstmm::__private::elements::Beam<T>,
        >: mstmm::__private::MemberGradient<
            S,
            Gradient = mstmm::__private::elements::InPlane<
                mstmm::__private::elements::Beam<S>,
            >,
        >,
        mstmm::__private::elements::Spring<
            T,
        >: mstmm::__private::MemberGradient<
            S,
            Gradient = mstmm::__private::elements::Spring<S>,
        >,
    {
        fn plane_chain(
            &self,
            states: &mstmm::__private::PlaneStates<'_, Self, S>,
        ) -> Self::PerField<S> {
            let zeros = <Self as mstmm::__private::Fields>::per_field(
                mstmm::__private::Scalar::from_f64(0.0),
            );
            let mut chain = mstmm::__private::ChainRule::new(zeros);
            let height = chain.variable(self.field_height);
            let stiffness = chain.variable(self.field_stiffness);
            let lamp = chain.variable(self.field_lamp);
            let mut lengths = [mstmm::__private::Scalar::from_f64(0.0); 2usize];
            let values = ();
            let gradient = <mstmm::__private::elements::InPlane<
                mstmm::__private::elements::Beam<T>,
            > as mstmm::__private::MemberGradient<
                S,
            >>::member_gradient(&self.member_0, &states.member_ends(0usize));
            lengths[0usize] = gradient.across.length;
            let values = (stiffness,);
            let gradient = <mstmm::__private::elements::Spring<
                T,
            > as mstmm::__private::MemberGradient<
                S,
            >>::member_gradient(&self.member_1, &states.member_ends(1usize));
            chain.add(gradient.stiffness, values.0);
            let mut slopes = [mstmm::__private::Scalar::from_f64(0.0); 10usize];
            mstmm::__private::geometry_slopes(
                &SKETCH,
                states,
                &self.geometry,
                &lengths,
                &mut slopes,
            );
            let numbers = (height, 0.5 * height, lamp, height);
            chain.add(slopes[3usize], numbers.0);
            chain.add(slopes[4usize], numbers.1);
            chain.add(slopes[6usize], numbers.2);
            chain.add(slopes[9usize], numbers.3);
            chain.finish()
        }
    }
    #[automatically_derived]
    impl<T> mstmm::__private::search::Undamped for MastSystem<T>
    where
        T: mstmm::__private::Real + mstmm::__private::InLanes,
        Self: mstmm::__private::search::RealPasses,
    {}
    #[automatically_derived]
    impl<T: mstmm::__private::Real> mstmm::__private::search::Spectrum for MastSystem<T>
    where
        Self: mstmm::__private::search::ComplexPasses,
    {}
};
