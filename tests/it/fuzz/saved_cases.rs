//! Every scene that ever failed, played again: `tests/data/hard`. The description of each tells what went wrong.

use masse::scenarios::file;

use super::sound;

#[test]
fn every_scene_that_ever_failed_is_sound() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/hard");
    let mut paths: Vec<_> = std::fs::read_dir(&folder)
        .expect("the folder of saved cases")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "ron"))
        .collect();
    paths.sort();
    assert!(!paths.is_empty());
    let mut failed = Vec::new();
    for path in paths {
        let scenario = file::read(&path).unwrap_or_else(|error| panic!("{error}"));
        let name = path
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        let ticks = [1.0 / 30.0, 1.0 / 120.0, 1e-3];
        let outcomes = std::iter::once(sound::exact(&scenario.scene))
            .chain(ticks.map(|tick| sound::stepped(&scenario.scene, tick)));
        failed.extend(
            outcomes
                .filter_map(Result::err)
                .map(|error| format!("{name}: {error}")),
        );
    }
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}
