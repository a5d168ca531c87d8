//! What labels, loads and entries are beside their model: plain values, which are copied and printed; and errors, which are printed as their text.

/// Copies and prints a value whatever the model is.
macro_rules! plain {
    ($name:ident<$($life:lifetime,)? M $(, $other:ident $(: $bound:ident)?)?>, $($field:ident),*) => {
        impl<$($life,)? M $(, $other $(: $bound)?)?> Clone for $name<$($life,)? M $(, $other)?> {
            fn clone(&self) -> Self {
                *self
            }
        }

        impl<$($life,)? M $(, $other $(: $bound)?)?> Copy for $name<$($life,)? M $(, $other)?> {}

        impl<$($life,)? M $(, $other $(: $bound)?)?> core::fmt::Debug for $name<$($life,)? M $(, $other)?> {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.debug_struct(stringify!($name))$(.field(stringify!($field), &self.$field))*.finish()
            }
        }
    };
}

/// Makes a type an error whose `Debug` is its text, so that a program whose `main` returns it prints a sentence.
macro_rules! error {
    ($name:ident) => {
        impl core::error::Error for $name {}

        impl core::fmt::Debug for $name {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                core::fmt::Display::fmt(self, f)
            }
        }
    };
}

pub(crate) use {error, plain};
