//! A match is agreed on, begun, watched and left with keys alone.

use masse::game::turns::{TurnCommand, Turns};
use masse::sim::stepping;

use super::*;

fn turns(app: &App) -> &Turns {
    app.world().resource::<Turns>()
}

#[test]
fn a_match_is_begun_with_keys_alone() {
    let mut app = app();
    press(&mut app, KeyCode::Escape);
    choose(&mut app, "New match");
    assert_eq!(page(&app), Some(PageId("match")));
    choose(&mut app, "9-ball");
    choose(&mut app, "Rosa");
    choose(&mut app, "Begin");
    assert_eq!(screen(&app), Screen::Table);
    stepping::step(&mut app, 2);
    let game = turns(&app).game().expect("it has begun");
    assert_eq!(game.setup().game.rules().code().name, "9-ball");
    // The first Rosa is that of the first player, who breaks.
    assert_eq!(turns(&app).level(), Some("Rosa"));
    assert!(!turns(&app).may_strike());
    step(&mut app);

    press(&mut app, KeyCode::Escape);
    choose(&mut app, "The match");
    assert_eq!(page(&app), Some(PageId("match-report")));
    press(&mut app, KeyCode::Escape);
    press(&mut app, KeyCode::Escape);
    assert_eq!(screen(&app), Screen::Table);
    app.world_mut().write_message(TurnCommand::Leave);
    stepping::step(&mut app, 2);
    assert!(!turns(&app).is_on());
}
