//! The cue as a file names it.

use serde::{Deserialize, Serialize};

use crate::physics::cue::{Cue, Stick, Tip};
use crate::physics::scene::within;
use crate::scenarios::file::{FieldError, LayoutError};

/// A cue; what is absent stays as it was.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default, rename = "Cue")]
pub(in crate::scenarios) struct CueEntry {
    #[serde(skip_serializing_if = "Option::is_none")]
    mass: Option<f64>,
    /// What the tip is made of.
    #[serde(skip_serializing_if = "Option::is_none")]
    tip: Option<Tip>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tip_restitution: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tip_radius: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    end_mass: Option<f64>,
    /// R. The same as `tip_friction`, said in another way.
    #[serde(skip_serializing_if = "Option::is_none")]
    miscue_offset: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tip_friction: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    stick: Option<StickEntry>,
}

/// The shape of a cue; what is absent stays as it was.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default, rename = "Stick")]
struct StickEntry {
    #[serde(skip_serializing_if = "Option::is_none")]
    length: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tip_width: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    butt_width: Option<f64>,
}

impl CueEntry {
    /// The entry of a cue with every number spelled out.
    pub(in crate::scenarios) fn of(cue: &Cue) -> Self {
        Self {
            mass: Some(cue.mass),
            tip: None,
            tip_restitution: Some(cue.tip_restitution),
            tip_radius: Some(cue.tip_radius),
            end_mass: Some(cue.end_mass),
            miscue_offset: Some(cue.miscue_offset),
            tip_friction: None,
            stick: Some(StickEntry {
                length: Some(cue.stick.length),
                tip_width: Some(cue.stick.tip_width),
                butt_width: Some(cue.stick.butt_width),
            }),
        }
    }

    /// This cue, with the rest taken from another one.
    pub(in crate::scenarios) fn or(&self, other: Cue) -> Result<Cue, LayoutError> {
        let tipped = self.tip.map_or(other, |tip| other.with_tip(tip));
        let miscue_offset = match (self.miscue_offset, self.tip_friction) {
            (Some(_), Some(_)) => {
                return Err(FieldError::OneOf {
                    parent: "cue".to_owned(),
                    choices: "`miscue_offset`, `tip_friction`",
                    count: 2,
                }
                .into());
            }
            (Some(offset), None) => offset,
            (None, Some(friction)) => {
                within("cue.tip_friction", friction, 0.0, 2.0)?;
                Cue::miscue_offset_of(friction)
            }
            (None, None) => other.miscue_offset,
        };
        if let (Some(tip), Some(value)) = (self.tip, self.tip_restitution) {
            let (least, most) = tip.measured_restitution();
            if !(least..=most).contains(&value) {
                let kind = match tip {
                    Tip::Leather => "leather",
                    Tip::Phenolic => "phenolic",
                };
                return Err(FieldError::Tip {
                    kind,
                    value,
                    least,
                    most,
                }
                .into());
            }
        }
        let stick = self.stick.unwrap_or_default();
        Ok(Cue {
            mass: self.mass.unwrap_or(other.mass),
            tip_restitution: self.tip_restitution.unwrap_or(tipped.tip_restitution),
            tip_radius: self.tip_radius.unwrap_or(other.tip_radius),
            end_mass: self.end_mass.unwrap_or(other.end_mass),
            miscue_offset,
            stick: Stick {
                length: stick.length.unwrap_or(other.stick.length),
                tip_width: stick.tip_width.unwrap_or(other.stick.tip_width),
                butt_width: stick.butt_width.unwrap_or(other.stick.butt_width),
            },
        })
    }
}
