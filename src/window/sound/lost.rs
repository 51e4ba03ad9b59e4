//! A sound device that is lost while the game runs: the player is told once, and the log is not filled.
//!
//! Bevy plays on into nothing, and its player reports that some thousand times a second. The first report is let through;
//! all later ones are dropped.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use bevy::log::BoxedLayer;
use bevy::log::tracing_subscriber::Layer;
use bevy::log::tracing_subscriber::layer::Context;
use bevy::prelude::*;

use crate::game::equip::Told;
use crate::game::saying::Saying;

/// Where the stream that plays reports from.
const STREAM: &str = "rodio::stream";

/// Whether the device was lost.
#[derive(Resource, Clone, Debug, Default)]
struct Lost(Arc<AtomicBool>);

impl<S: bevy::log::tracing::Subscriber> Layer<S> for Lost {
    fn event_enabled(&self, event: &bevy::log::tracing::Event<'_>, _: Context<'_, S>) -> bool {
        let is_error = *event.metadata().level() == bevy::log::Level::ERROR;
        let is_loss = is_error && event.metadata().target() == STREAM;
        !is_loss || !self.0.swap(true, Ordering::Relaxed)
    }
}

/// What the log of the app asks before it writes anything.
#[expect(
    clippy::unnecessary_wraps,
    reason = "the form in which the log asks for it"
)]
pub(in crate::window) fn layer(app: &mut App) -> Option<BoxedLayer> {
    let lost = Lost::default();
    app.insert_resource(lost.clone());
    Some(Box::new(lost))
}

pub(super) fn plugin(app: &mut App) {
    app.add_systems(
        Update,
        // It adds a notice: whatever reads notices reads it now or in the next frame.
        tell.run_if(resource_exists::<Lost>).ambiguous_with_all(),
    );
}

fn tell(lost: Res<Lost>, mut was_told: Local<bool>, mut told: MessageWriter<Told>) {
    if !*was_told && lost.0.load(Ordering::Relaxed) {
        *was_told = true;
        told.write(Told {
            text: Saying::new(
                "notice-sound-lost",
                &[],
                "The sound device is gone. Sound comes back when the game is started again.",
            ),
            is_failure: true,
        });
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicUsize;

    use bevy::log::tracing::{Event, Subscriber, error, subscriber};
    use bevy::log::tracing_subscriber::layer::SubscriberExt;
    use bevy::log::tracing_subscriber::registry;

    use super::*;

    struct Count(Arc<AtomicUsize>);

    impl<S: Subscriber> Layer<S> for Count {
        fn on_event(&self, _: &Event<'_>, _: Context<'_, S>) {
            self.0.fetch_add(1, Ordering::Relaxed);
        }
    }

    #[test]
    fn only_the_first_report_of_a_lost_device_reaches_the_log() {
        let (lost, count) = (Lost::default(), Arc::new(AtomicUsize::new(0)));
        let log = registry().with(lost.clone()).with(Count(count.clone()));
        subscriber::with_default(log, || {
            error!(target: "wgpu", "something else");
            assert!(!lost.0.load(Ordering::Relaxed));
            for _ in 0..1000 {
                error!(target: "rodio::stream", "the device is gone");
            }
            error!(target: "wgpu", "something else");
        });
        assert!(lost.0.load(Ordering::Relaxed));
        assert_eq!(count.load(Ordering::Relaxed), 3);
    }

    #[test]
    fn the_player_is_told_once_that_the_device_is_gone() {
        let mut app = App::new();
        app.add_plugins(MinimalPlugins).add_message::<Told>();
        let lost = Lost::default();
        app.insert_resource(lost.clone()).add_plugins(plugin);
        let told = |app: &mut App| {
            app.update();
            let mut told = app.world_mut().resource_mut::<Messages<Told>>();
            told.drain()
                .map(|told| (told.text.key, told.is_failure))
                .collect::<Vec<_>>()
        };
        assert_eq!(told(&mut app), []);
        lost.0.store(true, Ordering::Relaxed);
        assert_eq!(told(&mut app), [("notice-sound-lost".to_owned(), true)]);
        for _ in 0..5 {
            assert_eq!(told(&mut app), []);
        }
    }
}
