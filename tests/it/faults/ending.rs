//! The end of the program at any moment: what was kept is whole, and the match goes on from its last shot.

use bevy::prelude::*;
use masse::game::matches::{Match, Phase, Store};
use masse::game::settings::{Settings, SettingsFile, file};
use masse::game::turns::{MatchStore, TurnCommand, Turns};

use super::{begin, frame, moves, strike, table, to_rest};

fn game(app: &App) -> Match {
    let turns = app.world().resource::<Turns>();
    turns.game().expect("a match is on").clone()
}

#[test]
fn a_match_that_ends_in_the_midst_of_a_shot_goes_on_before_it() {
    for frames in [0, 1, 2, 5, 20, 60, 2000] {
        let folder = tempfile::tempdir().expect("a folder");
        let store = Store::in_folder(folder.path());
        let mut app = table();
        app.insert_resource(MatchStore(Some(store.clone())));
        begin(&mut app);
        strike(&mut app);
        frame(&mut app, 1.0 / 60.0);
        to_rest(&mut app);
        frame(&mut app, 1.0 / 60.0);
        if let [choice, ..] = game(&app).targets().choices[..] {
            app.world_mut().write_message(TurnCommand::Choose(choice));
            frame(&mut app, 0.1);
        }
        assert_eq!(game(&app).shots().len(), 1);
        strike(&mut app);
        for _ in 0..frames {
            frame(&mut app, 1.0 / 60.0);
        }
        assert_eq!(moves(&app), (1..2000).contains(&frames), "{frames}");
        app.world_mut().write_message(AppExit::Success);
        frame(&mut app, 1.0 / 60.0);
        let ended = game(&app);
        drop(app);
        let kept = store.load("autosave").expect("it is whole");
        assert_eq!(kept, ended, "after {frames} frames");
        assert_eq!(kept.shots().len(), 1 + usize::from(frames == 2000));
        let files = std::fs::read_dir(folder.path()).expect("a folder").count();
        assert_eq!(files, 1, "nothing is left half written");
        // It is gone on with.
        let mut again = table();
        again.insert_resource(MatchStore(Some(store)));
        again.world_mut().write_message(TurnCommand::Resume);
        frame(&mut again, 0.1);
        frame(&mut again, 0.1);
        assert_eq!(game(&again), kept);
        let phase = again.world().resource::<Turns>().phase();
        assert!(
            matches!(phase, Some(Phase::Play | Phase::Choose)),
            "{phase:?}"
        );
    }
}

#[test]
fn a_change_of_the_last_moment_is_kept() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("settings.ron");
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, masse::sim::SimPlugin))
        .insert_resource(SettingsFile(Some(path.clone())))
        .add_plugins(masse::game::GamePlugin);
    app.finish();
    app.cleanup();
    frame(&mut app, 0.016);
    app.world_mut().resource_mut::<Settings>().volume.muted = true;
    frame(&mut app, 0.016);
    assert!(!path.exists(), "a change settles first");
    app.world_mut().write_message(AppExit::Success);
    frame(&mut app, 0.016);
    assert!(file::load(&path).0.volume.muted);
}
