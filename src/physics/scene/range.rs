//! Numbers held against their ranges.

use std::fmt::{self, Display, Formatter};

use glam::{DVec2, DVec3};

use crate::physics::laws::{Check, Parameter};
use crate::physics::scene::SceneError;

/// Holds every parameter of a thing against its range.
pub(super) fn check_parameters(parent: &str, checked: &impl Check) -> Result<(), SceneError> {
    for parameter in checked.parameters() {
        check_parameter(&parameter.within(parent))?;
    }
    Ok(())
}

/// Holds a parameter against its range.
///
/// # Errors
/// [`SceneError::NotFinite`] or [`SceneError::OutOfRange`] with the field, the value and the source of the range.
pub fn check_parameter(parameter: &Parameter) -> Result<(), SceneError> {
    within_basis(
        &parameter.field,
        parameter.value,
        (parameter.least, parameter.most),
        parameter.basis,
    )
}

/// The path of a field in a list. It is written out only for an error: scenes are checked before every preview.
pub(super) struct Listed<'a> {
    pub list: &'a str,
    pub index: usize,
    pub name: Option<&'a str>,
    pub field: &'a str,
}

impl Display for Listed<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "{}[{}]", self.list, self.index)?;
        if let Some(name) = self.name {
            write!(f, " (`{name}`)")?;
        }
        write!(f, ".{}", self.field)
    }
}

pub(super) fn in_plan(field: impl Display, point: DVec2) -> Result<(), SceneError> {
    within(format_args!("{field}.x"), point.x, -1e4, 1e4)?;
    within(format_args!("{field}.z"), point.y, -1e4, 1e4)
}

pub(super) fn in_space(field: impl Display, vector: DVec3, most: f64) -> Result<(), SceneError> {
    for (axis, value) in ["x", "y", "z"].into_iter().zip(vector.to_array()) {
        within(format_args!("{field}.{axis}"), value, -most, most)?;
    }
    Ok(())
}

/// A number that is finite and between two ends, both allowed.
///
/// # Errors
/// [`SceneError::NotFinite`] or [`SceneError::OutOfRange`] with the field and the value.
pub fn within(field: impl Display, value: f64, least: f64, most: f64) -> Result<(), SceneError> {
    within_basis(field, value, (least, most), "")
}

/// As [`within`], with the source of the range.
fn within_basis(
    field: impl Display,
    value: f64,
    (least, most): (f64, f64),
    basis: &'static str,
) -> Result<(), SceneError> {
    let field = || field.to_string();
    if !value.is_finite() {
        return Err(SceneError::NotFinite {
            field: field(),
            value,
        });
    }
    if value < least || value > most {
        return Err(SceneError::OutOfRange {
            field: field(),
            value,
            least,
            most,
            basis,
        });
    }
    Ok(())
}
