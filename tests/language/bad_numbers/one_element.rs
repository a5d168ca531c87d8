//! For each keyword of the language a scene of one element, with the valid range of each of its parameters.

use mstmm::element::{ParameterError, SMatrix};
use mstmm::number::Scaled;
use mstmm::prelude::*;

pub(crate) type C = Complex<f64>;

/// Values of the parameters and ω to a determinant.
type AtOmega = fn(&[f64], f64) -> Scaled<f64>;

/// Which values a parameter may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Range {
    /// Greater than zero, and not extreme.
    Moderate,
    /// Zero, or greater and not extreme.
    ModerateOrZero,
    /// Greater than zero, with a finite reciprocal.
    Invertible,
    /// The same, or infinite, which is rigid.
    InvertibleOrRigid,
    /// Zero, or greater with a finite reciprocal.
    ZeroOrInvertible,
    /// Zero, or greater with a finite reciprocal and not extreme, or infinite, which is rigid.
    ZeroOrRigid,
    /// Zero, or greater and as far from zero as is not extreme.
    ZeroOrModerate,
    /// Zero, or greater and as far from zero as the fourth power is not extreme.
    ZeroOrTame,
    /// Zero or greater.
    NonNegative,
    /// Greater than zero, so that the fourth power is not extreme.
    Tame,
    /// Zero, or so.
    TameOrZero,
    /// So, or infinite, which is rigid.
    TameOrRigid,
    /// Any position.
    Position,
    /// Any speed.
    Speed,
    /// Greater than the axial force at which a beam of the other values loses its stiffness against shear.
    Tension,
    /// Not so large that a section vanishes or grows beyond a million times.
    Taper,
}

/// A parameter.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Parameter {
    pub(crate) name: &'static str,
    pub(crate) range: Range,
}

/// A scene of one element; its functions take the values of the parameters in order.
pub(crate) struct Scene {
    /// Name of the type in the core, which the model has, too; before that of a type that stretches `Planar`.
    pub(crate) type_name: &'static str,
    /// Keyword and label.
    pub(crate) element: &'static str,
    pub(crate) parameters: &'static [Parameter],
    pub(crate) build: fn(&[f64]) -> Result<(), ParameterError>,
    /// Determinant at λ, after a look at the matrix.
    pub(crate) at_lambda: fn(&[f64], C) -> Scaled<C>,
    /// Determinant at ω; `None` for a damper, which has none.
    pub(crate) at_omega: Option<AtOmega>,
}

impl Scene {
    /// Ordinary valid values: positions at the input end, sections that go down to a half, all else 1.
    pub(crate) fn ordinary(&self) -> Vec<f64> {
        let value = |parameter: &Parameter| match parameter.range {
            Range::Position | Range::Speed => 0.0,
            Range::Taper => 0.5,
            _ => 1.0,
        };
        self.parameters.iter().map(value).collect()
    }

    /// The ordinary values with one of them replaced.
    pub(crate) fn with(&self, index: usize, value: f64) -> Vec<f64> {
        let mut values = self.ordinary();
        values[index] = value;
        values
    }
}

/// Declares the models and the list of their scenes.
macro_rules! scenes {
    ($(
        $model:ident = $tip:ident -> $keyword:ident {
            $($parameter:ident: $range:ident),* $(,)?
        } -> $root:ident $([$spinning:ident])? $($undamped:ident)?;
    )*) => {
        $(
            system! {
                #[derive(Clone, Copy, Debug)]
                struct $model { $($parameter: f64),* }

                $tip -> $keyword 7 { $($parameter),* } -> $root
            }

            impl $model {
                fn of(values: &[f64]) -> Self {
                    let mut values = values.iter().copied();
                    $model { $($parameter: values.next().unwrap()),* }
                }
            }
        )*

        /// All scenes.
        pub(crate) const SCENES: &[Scene] = &[$(
            Scene {
                type_name: stringify!($model),
                element: concat!(stringify!($keyword), " 7"),
                parameters: &[
                    $(Parameter { name: stringify!($parameter), range: Range::$range }),*
                ],
                build: |values| $model::of(values).build().map(|_| ()),
                at_lambda: |values, lambda| evaluate(scenes!(@seen $model::of(values).build().unwrap() $(, $spinning)?), lambda),
                at_omega: scenes!(@at_omega $model $([$spinning])? $($undamped)?),
            },
        )*];
    };
    (@at_omega $model:ident $([$spinning:ident])? undamped) => {
        Some(|values, omega| evaluate(scenes!(@seen $model::of(values).build().unwrap() $(, $spinning)?), omega))
    };
    (@at_omega $model:ident $([$spinning:ident])?) => { None };
    (@seen $built:expr, spinning) => { $built.whirl(Whirl::Forward) };
    (@seen $built:expr) => { &$built };
}

/// The determinant; the matrix on its own must come back too.
fn evaluate<S: mstmm::number::Scalar, const N: usize>(
    system: &impl Evaluate<S, Matrix = SMatrix<S, N, N>>,
    frequency: S,
) -> Scaled<S> {
    let _ = core::hint::black_box(system.overall_matrix(frequency));
    system.overall_determinant(frequency)
}

scenes! {
    Beam = fixed -> beam { length: Moderate, bending_stiffness: Moderate, mass_per_length: ZeroOrModerate } -> free undamped;
    Body = free -> body {
        mass: NonNegative, inertia_about_input: NonNegative, output_x: Position, centre_x: Position,
    } -> free undamped;
    BodyColumn = free -> body {
        mass: NonNegative, inertia_about_input: NonNegative, output_x: Position, centre_x: Position, axial_force: Position,
    } -> free undamped;
    CentralBody = free -> body {
        mass: NonNegative, inertia: NonNegative, output_x: Position, centre_x: Position,
    } -> free undamped;
    CentralBodyColumn = free -> body {
        mass: NonNegative, inertia: NonNegative, output_x: Position, centre_x: Position, axial_force: Position,
    } -> free undamped;
    PlanarCentralBody = free -> body {
        mass: NonNegative, inertia: NonNegative,
        output_x: Position, output_y: Position, centre_x: Position, centre_y: Position,
    } -> free undamped;
    ElasticHinge = fixed -> hinge { stiffness_y: Invertible, stiffness_rz: Invertible } -> free undamped;
    Spring = fixed -> spring { stiffness: ZeroOrInvertible } -> free undamped;
    Damper = fixed -> damper { damping: NonNegative } -> free;
    SpringDamper = fixed -> spring { stiffness: ZeroOrInvertible, damping: NonNegative } -> free;
    TorsionSpring = fixed -> torsion_spring { stiffness: ZeroOrInvertible } -> free undamped;
    TorsionDamper = fixed -> torsion_damper { damping: NonNegative } -> free;
    TorsionSpringDamper = fixed -> torsion_spring { stiffness: ZeroOrInvertible, damping: NonNegative } -> free;
    Mass = free -> mass { mass: NonNegative } -> free undamped;
    Inertia = free -> inertia { inertia: NonNegative } -> free undamped;
    PointMass = free -> point_mass { mass: NonNegative, inertia: NonNegative } -> free undamped;
    TautString = fixed -> string {
        length: Moderate, tension: Moderate, mass_per_length: ZeroOrModerate, foundation_stiffness: ModerateOrZero,
    } -> free undamped;
    Rod = fixed -> rod {
        length: Moderate, axial_stiffness: Moderate, mass_per_length: ZeroOrModerate, foundation_stiffness: ModerateOrZero,
    } -> free undamped;
    Shaft = fixed -> shaft {
        length: Moderate, torsional_stiffness: Moderate, inertia_per_length: ZeroOrModerate,
    } -> free undamped;
    PlanarBeam = fixed -> beam {
        length: Moderate, axial_stiffness: Moderate, bending_stiffness: Moderate, mass_per_length: ZeroOrModerate,
    } -> free undamped;
    RayleighBeam = fixed -> beam {
        length: Tame, bending_stiffness: Tame, mass_per_length: ZeroOrTame, rotary_inertia: TameOrZero,
    } -> free undamped;
    TimoshenkoBeam = fixed -> beam {
        length: Tame, bending_stiffness: Tame, mass_per_length: ZeroOrTame, shear_stiffness: TameOrRigid, rotary_inertia: TameOrZero,
    } -> free undamped;
    BeamColumn = fixed -> beam {
        length: Tame, bending_stiffness: Tame, mass_per_length: ZeroOrTame, axial_force: Position,
    } -> free undamped;
    FoundationBeam = fixed -> beam {
        length: Tame, bending_stiffness: Tame, mass_per_length: ZeroOrTame,
        foundation_stiffness: TameOrZero, foundation_shear_stiffness: TameOrZero,
    } -> free undamped;
    PlanarRayleighBeam = fixed -> beam {
        length: Tame, axial_stiffness: Tame, bending_stiffness: Tame, mass_per_length: ZeroOrTame, rotary_inertia: TameOrZero,
    } -> free undamped;
    PlanarTimoshenkoBeam = fixed -> beam {
        length: Tame, axial_stiffness: Tame, bending_stiffness: Tame, mass_per_length: ZeroOrTame, shear_stiffness: TameOrRigid,
        rotary_inertia: TameOrZero,
    } -> free undamped;
    PlanarBeamColumn = fixed -> beam {
        length: Tame, axial_stiffness: Tame, bending_stiffness: Tame, mass_per_length: ZeroOrTame, axial_force: Position,
    } -> free undamped;
    PlanarFoundationBeam = fixed -> beam {
        length: Tame, axial_stiffness: Tame, bending_stiffness: Tame, mass_per_length: ZeroOrTame,
        foundation_stiffness: TameOrZero, foundation_shear_stiffness: TameOrZero,
    } -> free undamped;
    PlanarBody = free -> body {
        mass: NonNegative, inertia_about_input: NonNegative,
        output_x: Position, output_y: Position, centre_x: Position, centre_y: Position,
    } -> free undamped;
    PlanarHinge = fixed -> hinge {
        stiffness_x: InvertibleOrRigid, stiffness_y: InvertibleOrRigid, stiffness_rz: InvertibleOrRigid,
    } -> free undamped;
    DampedHinge = fixed -> hinge {
        stiffness_y: ZeroOrRigid, stiffness_rz: ZeroOrRigid, damping_y: ModerateOrZero, damping_rz: ModerateOrZero,
        loss_factor: ModerateOrZero, kelvin_voigt_time: ModerateOrZero,
    } -> free;
    DampedPlanarHinge = fixed -> hinge {
        stiffness_x: ZeroOrRigid, stiffness_y: ZeroOrRigid, stiffness_rz: ZeroOrRigid, damping_x: ModerateOrZero,
        damping_y: ModerateOrZero, damping_rz: ModerateOrZero, loss_factor: ModerateOrZero, kelvin_voigt_time: ModerateOrZero,
    } -> free;
    RotationalHinge = fixed -> hinge { stiffness_rz: NonNegative } -> free undamped;
    ShearHinge = fixed -> hinge { stiffness_y: NonNegative } -> free undamped;
    Lever = fixed -> rigid_link { output_x: Position } -> free undamped;
    LeverColumn = fixed -> rigid_link { output_x: Position, axial_force: Position } -> free undamped;
    TaperedBeam = fixed -> tapered_beam {
        length: Tame, bending_stiffness: Tame, mass_per_length: Tame, width_taper: Taper, height_taper: Taper,
        rotary_inertia: TameOrZero, axial_force: Position, axial_load: Position, rotation_speed: TameOrZero, hub_radius: Position, setting_angle: Position,
        foundation_stiffness: Position,
    } -> free undamped;
    DampedSpring = fixed -> spring { stiffness: ZeroOrInvertible, loss_factor: NonNegative, kelvin_voigt_time: NonNegative, damping: NonNegative } -> free;
    DampedTorsionSpring = fixed -> torsion_spring { stiffness: ZeroOrInvertible, loss_factor: NonNegative, kelvin_voigt_time: NonNegative, damping: NonNegative } -> free;
    DampedString = fixed -> string {
        length: Moderate, tension: Moderate, mass_per_length: ZeroOrModerate, foundation_stiffness: ModerateOrZero, external_damping: NonNegative,
    } -> free;
    DampedRod = fixed -> rod {
        length: Moderate, axial_stiffness: Moderate, mass_per_length: ZeroOrModerate, foundation_stiffness: ModerateOrZero,
        loss_factor: NonNegative, kelvin_voigt_time: NonNegative, external_damping: NonNegative,
    } -> free;
    DampedShaft = fixed -> shaft {
        length: Moderate, torsional_stiffness: Moderate, inertia_per_length: ZeroOrModerate, loss_factor: NonNegative, kelvin_voigt_time: NonNegative,
        external_damping: NonNegative,
    } -> free;
    GeneralBeam = fixed -> beam {
        length: Tame, bending_stiffness: Tame, mass_per_length: ZeroOrTame, shear_stiffness: TameOrRigid,
        rotary_inertia: TameOrZero, axial_force: Tension, foundation_stiffness: TameOrZero,
        foundation_shear_stiffness: TameOrZero,
    } -> free undamped;
    PlanarGeneralBeam = fixed -> beam {
        length: Tame, axial_stiffness: Tame, bending_stiffness: Tame, mass_per_length: ZeroOrTame, shear_stiffness: TameOrRigid,
        rotary_inertia: TameOrZero, axial_force: Tension, foundation_stiffness: TameOrZero,
        foundation_shear_stiffness: TameOrZero,
    } -> free undamped;
    DampedBeam = fixed -> beam {
        length: Tame, bending_stiffness: Tame, mass_per_length: ZeroOrTame, shear_stiffness: TameOrRigid,
        rotary_inertia: TameOrZero, axial_force: Tension, foundation_stiffness: TameOrZero,
        foundation_shear_stiffness: TameOrZero, loss_factor: NonNegative, kelvin_voigt_time: NonNegative, external_damping: NonNegative,
    } -> free;
    SpinningBeam = fixed -> beam {
        length: Tame, bending_stiffness: Tame, mass_per_length: ZeroOrTame, shear_stiffness: TameOrRigid,
        rotary_inertia: TameOrZero, axial_force: Tension, foundation_stiffness: TameOrZero,
        foundation_shear_stiffness: TameOrZero, polar_inertia_per_length: NonNegative, speed: Speed,
    } -> free [spinning] undamped;
    DampedSpinningBeam = fixed -> beam {
        length: Tame, bending_stiffness: Tame, mass_per_length: ZeroOrTame, shear_stiffness: TameOrRigid,
        rotary_inertia: TameOrZero, axial_force: Tension, foundation_stiffness: TameOrZero,
        foundation_shear_stiffness: TameOrZero, polar_inertia_per_length: NonNegative, speed: Speed,
        kelvin_voigt_time: NonNegative, external_damping: NonNegative,
    } -> free [spinning];
    Disc = free -> disc {
        mass: NonNegative, inertia: NonNegative, polar_inertia: NonNegative, speed: Speed,
    } -> free [spinning] undamped;
    CrossCoupledSpring = fixed -> spring {
        stiffness: ZeroOrInvertible, loss_factor: NonNegative, kelvin_voigt_time: NonNegative, damping: NonNegative,
        cross_stiffness: Position, cross_damping: Position,
    } -> free [spinning];
    PlanarDampedBeam = fixed -> beam {
        length: Tame, axial_stiffness: Tame, bending_stiffness: Tame, mass_per_length: ZeroOrTame, shear_stiffness: TameOrRigid,
        rotary_inertia: TameOrZero, axial_force: Tension, foundation_stiffness: TameOrZero,
        foundation_shear_stiffness: TameOrZero, loss_factor: NonNegative, kelvin_voigt_time: NonNegative, external_damping: NonNegative,
    } -> free;
}
