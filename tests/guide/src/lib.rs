//! The pages of the guide, whose models are compiled and run, all in one program.

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/bodies.md")]
struct Bodies;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/certificates.md")]
struct Certificates;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/controller.md")]
struct Controller;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/damping.md")]
struct Damping;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/earthquake.md")]
struct Earthquake;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/finite_elements.md")]
struct FiniteElements;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/first_model.md")]
struct FirstModel;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/frames.md")]
struct Frames;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/from_file.md")]
struct FromFile;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/free_systems.md")]
struct FreeSystems;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/generic_code.md")]
struct GenericCode;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/identification.md")]
struct Identification;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/many_models.md")]
struct ManyModels;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/moving_loads.md")]
struct MovingLoads;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/no_std.md")]
struct NoStd;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/own_elements.md")]
struct OwnElements;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/repeated.md")]
struct Repeated;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/responses.md")]
struct Responses;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/shaker.md")]
struct Shaker;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/signs.md")]
struct Signs;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/rotors.md")]
struct Rotors;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/space.md")]
struct FramesInSpace;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/stability.md")]
struct Stability;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/tolerances.md")]
struct Tolerances;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/tower.md")]
struct Tower;
