//! Single numbers of an equipment, set by the path that error messages use: `laws.cushion.restitution`.
//!
//! The numbers are found through their serialized form, so a new law needs nothing here. The name of the law in use is
//! not part of a path.

use std::collections::BTreeMap;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::physics::ball::Ball;
use crate::physics::cue::Cue;
use crate::physics::equipment::Equipment;
use crate::physics::laws::{Check, Laws, Parameter};
use crate::physics::scene::{Scene, SceneError};
use crate::scenarios::file::{FieldError, LayoutError};

/// Numbers by their paths.
pub(super) type Numbers = BTreeMap<String, f64>;

/// What can be set in an equipment.
#[derive(Serialize, Deserialize)]
struct Settable {
    table: SettableTable,
    laws: Laws,
    cue: Cue,
    ball: Ball,
    cue_ball: Ball,
}

/// Of a table only what does not move its noses and pockets.
#[derive(Serialize, Deserialize)]
struct SettableTable {
    nose_height: f64,
}

/// What can be set in a scene whose balls are there already.
#[derive(Serialize, Deserialize)]
struct Surroundings {
    table: SettableTable,
    laws: Laws,
    cue: Cue,
}

/// Sets these numbers.
pub(super) fn set(equipment: &mut Equipment, numbers: &Numbers) -> Result<(), LayoutError> {
    if numbers.is_empty() {
        return Ok(());
    }
    finite(equipment)?;
    let all = Settable {
        table: SettableTable {
            nose_height: equipment.table.nose_height,
        },
        laws: equipment.laws,
        cue: equipment.cue,
        ball: equipment.balls.object,
        cue_ball: equipment.balls.cue,
    };
    let numbers = numbers.iter().map(|(path, value)| (path.as_str(), *value));
    let all = changed(&all, numbers)?;
    equipment.table.nose_height = all.table.nose_height;
    equipment.laws = all.laws;
    equipment.cue = all.cue;
    equipment.balls.object = all.ball;
    equipment.balls.cue = all.cue_ball;
    Ok(())
}

/// Sets numbers of the laws, the cue and the table of a scene.
pub(in crate::scenarios) fn set_in_scene<'n>(
    scene: &mut Scene,
    numbers: impl Iterator<Item = (&'n str, f64)>,
) -> Result<(), LayoutError> {
    let all = Surroundings {
        table: SettableTable {
            nose_height: scene.table.nose_height,
        },
        laws: scene.laws,
        cue: scene.cue,
    };
    let all = changed(&all, numbers)?;
    scene.table.nose_height = all.table.nose_height;
    scene.laws = all.laws;
    scene.cue = all.cue;
    Ok(())
}

/// The same with other numbers.
fn changed<'n, T: Serialize + DeserializeOwned>(
    all: &T,
    numbers: impl Iterator<Item = (&'n str, f64)>,
) -> Result<T, LayoutError> {
    let unwritable = |error: serde_json::Error| {
        let message = error.to_string();
        LayoutError::from(crate::scenarios::file::FileError::Write { message })
    };
    let mut tree = serde_json::to_value(all).map_err(unwritable)?;
    for (path, value) in numbers {
        if !value.is_finite() {
            let field = path.to_owned();
            return Err(SceneError::NotFinite { field, value }.into());
        }
        *number(&mut tree, path)? = Value::from(value);
    }
    serde_json::from_value(tree).map_err(unwritable)
}

/// No number that stands already is infinite or none: such have no serialized form.
fn finite(equipment: &Equipment) -> Result<(), SceneError> {
    let balls = [
        ("ball", &equipment.balls.object),
        ("cue_ball", &equipment.balls.cue),
    ];
    let bodies = balls.iter().flat_map(|(name, ball)| {
        let numbers = [("mass", ball.mass), ("radius", ball.radius)];
        numbers.map(|(field, value)| (format!("{name}.{field}"), value))
    });
    let named = |class: &'static str| {
        move |parameter: Parameter| (format!("{class}.{}", parameter.field), parameter.value)
    };
    let laws = equipment.laws.parameters().into_iter().map(named("laws"));
    let cue = equipment.cue.parameters().into_iter().map(named("cue"));
    let height = std::iter::once(("table.nose_height".to_owned(), equipment.table.nose_height));
    let mut all = bodies.chain(laws).chain(cue).chain(height);
    match all.find(|(_, value)| !value.is_finite()) {
        Some((field, value)) => Err(SceneError::NotFinite { field, value }),
        None => Ok(()),
    }
}

/// The place of the number with this path.
fn number<'a>(tree: &'a mut Value, path: &str) -> Result<&'a mut Value, FieldError> {
    let mut place = tree;
    let mut walked: Vec<&str> = Vec::new();
    for name in path.split('.') {
        let known = names(place);
        let parent = walked.join(".");
        place = inside(place)
            .get_mut(name)
            .ok_or_else(|| FieldError::NoSuchNumber {
                path: path.to_owned(),
                parent: if parent.is_empty() {
                    "set".to_owned()
                } else {
                    parent
                },
                known,
            })?;
        walked.push(name);
    }
    let known = names(place);
    let place = inside(place);
    if place.is_number() {
        return Ok(place);
    }
    Err(FieldError::NoSuchNumber {
        path: path.to_owned(),
        parent: path.to_owned(),
        known,
    })
}

/// What is inside the name of a law: `{"Mirror": {…}}` becomes `{…}`.
fn inside(mut place: &mut Value) -> &mut Value {
    while let Some(law) = law(place) {
        place = &mut place[law.as_str()];
    }
    place
}

/// The name of the law that this is.
fn law(place: &Value) -> Option<String> {
    let fields = place.as_object().filter(|fields| fields.len() == 1)?;
    let name = fields.keys().next()?;
    name.starts_with(|c: char| c.is_ascii_uppercase())
        .then(|| name.clone())
}

/// The names of what is inside, for an error.
fn names(place: &mut Value) -> String {
    match inside(place) {
        Value::Object(fields) => fields.keys().cloned().collect::<Vec<_>>().join(", "),
        _ => "no numbers inside".to_owned(),
    }
}
