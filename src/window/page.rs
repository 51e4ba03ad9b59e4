//! Where the menu is hung up: its pages, the games that can be begun, and which page is open.
//!
//! A page is a system that lays out its part of the menu, in a file of whoever needs it:
//!
//! ```ignore
//! app.add_page(Page { id: PageId("match"), title: "match-title", place: Some(15) }, show);
//!
//! fn show(InMut(ui): InMut<egui::Ui>, language: Res<Language>, mut open: ResMut<Open>) { ... }
//! ```
//!
//! A game to begin is [`AddPages::add_mode`]: the page "Practice and scenes" lists it.

use bevy::ecs::system::SystemId;
use bevy::prelude::*;
use bevy_egui::egui;

/// What has the keys and the pointer.
#[derive(States, Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Screen {
    /// The table.
    #[default]
    Table,
    /// The menu, over the table.
    Menu,
}

/// What a panel is remembered by: its name and the size of the window. A window that was made tiny for a while, or
/// minimised, would leave its panels squeezed and pushed aside for good.
#[must_use]
pub fn panel_id(context: &egui::Context, name: &str) -> egui::Id {
    let size = context.content_rect().size();
    egui::Id::new((name, size.x as i32, size.y as i32))
}

/// A panel in the upper right corner, and the button that brings it back once it is closed.
pub struct SidePanel {
    /// What it is remembered by.
    pub name: &'static str,
    /// Its heading, and what the button says.
    pub title: String,
    /// Width in points.
    pub width: f32,
    /// Points below it that are not its own.
    pub below: f32,
}

impl SidePanel {
    /// Lays out the panel, or the button. Returns whether it is open from now on.
    pub fn show(
        self,
        context: &egui::Context,
        open: bool,
        contents: impl FnOnce(&mut egui::Ui),
    ) -> bool {
        let margin = egui::vec2(-8.0, 8.0);
        if !open {
            return egui::Area::new(egui::Id::new((self.name, "panel button")))
                .anchor(egui::Align2::RIGHT_TOP, margin)
                .show(context, |ui| ui.button(self.title).clicked())
                .inner;
        }
        let mut stays = true;
        let room = context.content_rect();
        egui::Window::new(self.title)
            .id(panel_id(context, self.name))
            .open(&mut stays)
            .pivot(egui::Align2::RIGHT_TOP)
            .default_pos(room.right_top() + margin)
            .auto_sized()
            .show(context, |ui| {
                ui.set_width(self.width);
                egui::ScrollArea::vertical()
                    .max_height(room.height() - self.below)
                    .show(ui, contents);
            });
        stays
    }
}

/// The name of a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PageId(pub &'static str);

impl PageId {
    /// The page that the menu opens with.
    pub const MAIN: Self = Self("menu");
    /// Games to begin.
    pub const NEW_GAME: Self = Self("new-game");
    /// What is played on and with.
    pub const EQUIPMENT: Self = Self("equipment");
    /// Settings.
    pub const SETTINGS: Self = Self("settings");
    /// Every control.
    pub const HELP: Self = Self("help");
}

/// A page of the menu.
#[derive(Clone, Copy, Debug)]
pub struct Page {
    /// Its name.
    pub id: PageId,
    /// The key of its heading and of the button that leads to it.
    pub title: &'static str,
    /// The page that has a button for it, and where among the buttons, from small to large.
    pub place: Option<(PageId, i32)>,
}

/// A system that lays out a page.
pub type Show = SystemId<InMut<'static, egui::Ui>>;

/// Every page, in the order of their buttons.
#[derive(Resource, Default)]
pub struct Pages(Vec<(Page, Show)>);

impl Pages {
    /// A page by its name.
    #[must_use]
    pub fn get(&self, id: PageId) -> Option<(Page, Show)> {
        self.0.iter().copied().find(|(page, _)| page.id == id)
    }

    /// The pages that another page leads to.
    pub fn below(&self, id: PageId) -> impl Iterator<Item = Page> {
        self.0
            .iter()
            .map(|(page, _)| *page)
            .filter(move |page| page.place.is_some_and(|(above, _)| above == id))
    }
}

/// A game that can be begun.
#[derive(Clone, Debug)]
pub struct Mode {
    /// The key of the heading it stands under.
    pub group: &'static str,
    /// The key of its name.
    pub title: String,
    /// Its name if no language knows the key.
    pub name: String,
    /// The key of a line about it, if there is one.
    pub about: Option<&'static str>,
}

/// Every game that can be begun, in the order in which they were added.
#[derive(Resource, Default)]
pub struct Modes(pub Vec<(Mode, SystemId)>);

/// Which page is open, and those that lead to it; empty while the table is played on.
#[derive(Resource, Clone, Debug, Default, PartialEq, Eq)]
pub struct Open(Vec<PageId>);

impl Open {
    /// The page that is open.
    #[must_use]
    pub fn page(&self) -> Option<PageId> {
        self.0.last().copied()
    }

    /// How many pages lead to the one that is open, itself included.
    #[must_use]
    pub fn depth(&self) -> usize {
        self.0.len()
    }

    /// Opens a page; the way back leads to the one that is open now.
    pub fn go(&mut self, id: PageId) {
        if self.0.is_empty() && id != PageId::MAIN {
            self.0.push(PageId::MAIN);
        }
        self.0.push(id);
    }

    /// Back by one page, to the table from the first.
    pub fn back(&mut self) {
        self.0.pop();
    }

    /// Back to the table.
    pub fn close(&mut self) {
        self.0.clear();
    }
}

/// Adds pages and games to the menu.
pub trait AddPages {
    /// Adds a page and the system that lays it out.
    fn add_page<M>(
        &mut self,
        page: Page,
        show: impl IntoSystem<InMut<'static, egui::Ui>, (), M> + 'static,
    ) -> &mut Self;

    /// Adds a game and the system that begins it. The menu closes by itself.
    fn add_mode<M>(&mut self, mode: Mode, begin: impl IntoSystem<(), (), M> + 'static)
    -> &mut Self;
}

impl AddPages for App {
    fn add_page<M>(
        &mut self,
        page: Page,
        show: impl IntoSystem<InMut<'static, egui::Ui>, (), M> + 'static,
    ) -> &mut Self {
        let show = self.world_mut().register_system(show);
        let mut pages = self.world_mut().get_resource_or_init::<Pages>();
        pages.0.push((page, show));
        pages
            .0
            .sort_by_key(|(page, _)| page.place.map_or(0, |(_, order)| order));
        self
    }

    fn add_mode<M>(
        &mut self,
        mode: Mode,
        begin: impl IntoSystem<(), (), M> + 'static,
    ) -> &mut Self {
        let begin = self.world_mut().register_system(begin);
        let mut modes = self.world_mut().get_resource_or_init::<Modes>();
        modes.0.push((mode, begin));
        self
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_state::<Screen>()
        .init_resource::<Pages>()
        .init_resource::<Modes>()
        .init_resource::<Open>()
        .add_systems(PreUpdate, follow.after(super::WindowSystems::Input));
}

/// The screen follows the page.
fn follow(open: Res<Open>, screen: Res<State<Screen>>, mut next: ResMut<NextState<Screen>>) {
    let wanted = if open.page().is_some() {
        Screen::Menu
    } else {
        Screen::Table
    };
    if *screen.get() != wanted {
        next.set(wanted);
    }
}
