//! Convergence: what the game uses against steps so fine that more change nothing.
