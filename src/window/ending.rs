//! How the program ends: as whoever asks for it from outside expects, and with what nobody could read on the screen any more.

use std::io::{self, Write};

use bevy::prelude::*;

use crate::game::Keeping;
use crate::game::equip::Told;
use crate::game::turns::TurnNews;

pub(super) fn plugin(app: &mut App) {
    app.add_message::<AppExit>().add_systems(
        Last,
        // It only reads: whatever runs beside it.
        last_words
            .run_if(on_message::<AppExit>)
            .after(Keeping)
            .ambiguous_with_all(),
    );
}

/// Whoever shuts down the machine, logs out or closes the terminal lets this program save first, as it does when its window
/// is closed; whoever asks twice does not wait. Bevy listens to Ctrl-C itself.
#[cfg(unix)]
pub(super) fn listen(app: &mut App) {
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

    use signal_hook::consts::{SIGHUP, SIGTERM};
    use signal_hook::flag::{register, register_conditional_default, register_usize};

    let (asked, twice) = (
        Arc::new(AtomicUsize::new(0)),
        Arc::new(AtomicBool::new(false)),
    );
    for signal in [SIGTERM, SIGHUP] {
        let number = usize::try_from(signal).unwrap_or_default();
        // What is registered first is asked first.
        let heard = register_conditional_default(signal, twice.clone())
            .and_then(|_| register(signal, twice.clone()))
            .and_then(|_| register_usize(signal, asked.clone(), number));
        if let Err(error) = heard {
            warn!("signal {signal} ends the program at once: {error}");
        }
    }
    app.add_systems(Update, move |mut exits: MessageWriter<AppExit>| {
        let signal = asked.load(Ordering::Relaxed);
        if let Ok(signal @ 1..) = u8::try_from(signal) {
            exits.write(AppExit::from_code(128 + signal));
        }
    });
}

/// Elsewhere the system closes the window.
#[cfg(not(unix))]
pub(super) fn listen(_: &mut App) {}

/// What went wrong at the very end, each once.
fn last_words(
    mut told: MessageReader<Told>,
    mut news: MessageReader<TurnNews>,
    mut said: Local<Vec<String>>,
) {
    let unsaved = news.read().filter_map(|news| match news {
        TurnNews::NotSaved(error) => Some(format!("the match is not saved: {error}")),
        _ => None,
    });
    let failures = told.read().filter(|told| told.is_failure);
    for line in unsaved.chain(failures.map(|told| told.text.english.clone())) {
        if !said.contains(&line) {
            // Nobody listening is no error.
            let _ = writeln!(io::stderr(), "masse: {line}");
            said.push(line);
        }
    }
}
