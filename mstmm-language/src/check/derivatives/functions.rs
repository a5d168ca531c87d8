//! The functions whose derivatives are known: those of `mstmm_core::Partials` and of `mstmm_core::sections`.

use super::{Dependence, Formulas};
use proc_macro2::Ident;
use quote::{ToTokens, quote_spanned};
use syn::{Expr, ExprCall, ExprMethodCall, ExprPath};

/// Functions of `f64` with derivatives in all arguments, by the number of arguments beside the first.
const FUNCTIONS: [&[&str]; 3] = [
    &[
        "abs",
        "acos",
        "asin",
        "atan",
        "cbrt",
        "cos",
        "cosh",
        "exp",
        "exp_m1",
        "ln",
        "ln_1p",
        "log10",
        "log2",
        "recip",
        "signum",
        "sin",
        "sinh",
        "sqrt",
        "tan",
        "tanh",
        "to_degrees",
        "to_radians",
    ],
    &["atan2", "hypot", "max", "min", "powf"],
    &["clamp", "mul_add"],
];

/// Functions of `mstmm::sections`: each returns a tuple of so many numbers.
const SECTIONS: [(&[&str], usize); 2] = [
    (&["box_section", "i_section", "rectangle", "round", "tube"], 4),
    (&["box_shear", "i_shear", "rectangle_shear", "round_shear", "tube_shear"], 2),
];

/// How many of its first arguments are numbers of a formula, if the function is known.
fn numbers_of(name: &Ident, arguments: &[Dependence]) -> Option<usize> {
    if name == "powi" {
        return matches!(arguments, [Dependence::Number(_), Dependence::None]).then_some(1);
    }
    let names = FUNCTIONS.get(arguments.len().checked_sub(1)?)?;
    let is_known = names.iter().any(|known| name == known) && !arguments.iter().any(Dependence::is_tuple);
    is_known.then_some(arguments.len())
}

/// The name in `f64::name`.
fn of_f64(function: &Expr) -> Option<&Ident> {
    let Expr::Path(ExprPath { qself: None, path, .. }) = function else { return None };
    let mut segments = path.segments.iter().map(|segment| &segment.ident);
    let (kind, name) = (segments.next()?, segments.next()?);
    (kind == "f64" && segments.next().is_none()).then_some(name)
}

/// How many numbers the function `sections::name` returns.
fn parts_of_section(function: &Expr) -> Option<usize> {
    let Expr::Path(ExprPath { qself: None, path, .. }) = function else { return None };
    let mut segments = path.segments.iter().rev().map(|segment| &segment.ident);
    let (name, module) = (segments.next()?, segments.next()?);
    let row = SECTIONS.iter().find(|(names, _)| names.iter().any(|known| name == known))?;
    (module == "sections").then_some(row.1)
}

impl Formulas<'_> {
    /// `number.function(..)`
    pub(super) fn method(&mut self, call: &mut ExprMethodCall) -> Dependence {
        let arguments = std::iter::once(&mut *call.receiver).chain(&mut call.args).collect();
        self.function(arguments, Some(&call.method), &call.method, &format!("`{}`", call.method))
    }

    /// `function(..)`; `f64::function(number, ..)` becomes `(number).function(..)`.
    pub(super) fn call(&mut self, expression: &mut Expr) -> Dependence {
        let Expr::Call(call) = expression else { return Dependence::None };
        self.expression(&mut call.func);
        if let Some(parts) = parts_of_section(&call.func) {
            return self.section(call, parts);
        }
        let (known_as, name) = (of_f64(&call.func).cloned(), called(&call.func));
        let dependence = self.function(call.args.iter_mut().collect(), known_as.as_ref(), &call.func, &name);
        if let (Some(method), false) = (known_as, dependence.is_none()) {
            let mut arguments = call.args.iter();
            let (number, span) = (arguments.next(), self.at(method.span()));
            *expression = Expr::Verbatim(quote_spanned!(span=> (#number).#method(#(#arguments),*)));
        }
        dependence
    }

    /// `sections::name(size, ..)`
    fn section(&mut self, call: &mut ExprCall, parts: usize) -> Dependence {
        let dependences: Vec<_> = call.args.iter_mut().map(|argument| self.expression(argument)).collect();
        let all = Dependence::all(&dependences);
        if dependences.iter().any(Dependence::is_tuple) {
            return self.refuse(&all, &call.func, &called(&call.func), "give it one number for each size");
        }
        for (argument, dependence) in call.args.iter_mut().zip(&dependences) {
            self.lift(argument, dependence, &all);
        }
        Dependence::of_tuple(vec![all; parts])
    }

    /// The value of a function, if no argument depends on fields or its derivative is known.
    fn function(
        &mut self,
        mut arguments: Vec<&mut Expr>,
        known_as: Option<&Ident>,
        place: impl ToTokens,
        name: &str,
    ) -> Dependence {
        let dependences: Vec<_> = arguments.iter_mut().map(|argument| self.expression(argument)).collect();
        let all = Dependence::all(&dependences);
        if all.is_none() {
            return all;
        }
        let Some(numbers) = known_as.and_then(|function| numbers_of(function, &dependences)) else {
            return self.refuse(&all, place, name, "write the formula here");
        };
        for (argument, dependence) in arguments.into_iter().zip(&dependences).take(numbers) {
            self.lift(argument, dependence, &all);
        }
        all
    }
}

/// What is called, for a message.
fn called(function: &Expr) -> String {
    match function {
        Expr::Path(path) => format!("`{}`", path.to_token_stream().to_string().replace(' ', "")),
        _ => "this function".to_owned(),
    }
}
